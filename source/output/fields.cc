// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/output/fields.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/hdf5.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/fe/mapping_fe_field.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>

namespace Riedel::Output
{
  namespace
  {
    using Interpretation =
      dealii::DataComponentInterpretation::DataComponentInterpretation;

    /// Files some per cent larger, written several times faster.
    constexpr auto compression = dealii::DataOutBase::VtkFlags::best_speed;



    /// Points as patches of no dimension, so that deal.II can write them.
    template <int dim>
    class PointPatches : public dealii::DataOutInterface<0, dim>
    {
    public:
      PointPatches(const Points::MaterialPoints<dim> &points,
                   const PointFields                 &fields)
      {
        for (const auto &field : fields.fields())
          for (unsigned int c = 0; c < field.components.size(); ++c)
            names.push_back(field.file_name(c));

        patches.resize(points.n_points());
        std::vector<double> values(fields.n_values());
        for (unsigned int p = 0; p < points.n_points(); ++p)
          {
            auto         &patch = patches[p];
            const double *row   = points.row(p);
            patch.patch_index   = p;
            patch.vertices[0]   = points.position(p);
            patch.data.reinit(values.size(), 1);
            fields.evaluate(row, values.data());
            for (unsigned int i = 0; i < values.size(); ++i)
              patch.data(i, 0) = static_cast<float>(values[i]);
          }
      }

    private:
      const std::vector<dealii::DataOutBase::Patch<0, dim>> &
      get_patches() const override
      {
        return patches;
      }

      std::vector<std::string>
      get_dataset_names() const override
      {
        return names;
      }

      std::vector<dealii::DataOutBase::Patch<0, dim>> patches;
      std::vector<std::string>                        names;
    };



    /// Volume means of the points' fields, per active cell.
    template <int dim>
    std::vector<dealii::Vector<float>>
    cell_means(const dealii::Triangulation<dim>  &triangulation,
               const Points::MaterialPoints<dim> &points,
               const PointFields                 &fields)
    {
      std::vector<dealii::Vector<float>> means(
        fields.n_values(),
        dealii::Vector<float>(triangulation.n_active_cells()));
      std::vector<double> values(fields.n_values()), sums(fields.n_values());
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            double volume = 0.0;
            std::fill(sums.begin(), sums.end(), 0.0);
            for (const auto &particle :
                 points.particles().particles_in_cell(cell))
              {
                const double *row = particle.get_properties().data();
                const double  V   = row[points.place.volume];
                fields.evaluate(row, values.data());
                for (unsigned int i = 0; i < values.size(); ++i)
                  sums[i] += V * values[i];
                volume += V;
              }
            if (volume > 0.0)
              for (unsigned int i = 0; i < sums.size(); ++i)
                means[i](cell->active_cell_index()) =
                  static_cast<float>(sums[i] / volume);
          }
      return means;
    }



    void
    write_collection(const std::string                                 &path,
                     const std::vector<std::pair<double, std::string>> &files)
    {
      std::ofstream stream(path);
      dealii::DataOutBase::write_pvd_record(stream, files);
    }
  } // namespace



  template <int dim>
  Fields<dim>::Fields(const ResultsFolder &folder, const Parameters &parameters)
    : folder(&folder)
    , parameters(parameters)
  {}



  template <int dim>
  void
  Fields<dim>::write(const double                       load,
                     const Grid::Space<dim>            &space,
                     const std::vector<double>         &solution,
                     const Points::MaterialPoints<dim> &points)
  {
    const MPI_Comm communicator = space.communicator();
    const bool     is_first_rank =
      dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
    const std::string number = dealii::Utilities::int_to_string(
      std::max(grid_files.size(), point_files.size()), 4);

    if (parameters.write_grid)
      {
        const std::string name = "grid-" + number + ".vtu";
        write_grid(folder->path(name), space, solution, points);
        grid_files.emplace_back(load, name);
        if (is_first_rank)
          write_collection(folder->path("grid.pvd"), grid_files);
      }
    if (parameters.write_points)
      {
        const std::string name = "points-" + number;
        write_points(folder->path(name), load, communicator, points);
        point_files.emplace_back(load, name + ".vtu");
        if (is_first_rank)
          write_collection(folder->path("points.pvd"), point_files);
      }
  }



  template <int dim>
  void
  Fields<dim>::resume() const
  {
    namespace fs = std::filesystem;
    const std::regex names("(grid|points)-([0-9]+)\\.(vtu|pvtu|h5)");
    const auto       n_sets = std::max(grid_files.size(), point_files.size());
    std::vector<fs::path> newer;
    for (const auto &file : fs::directory_iterator(folder->name()))
      {
        const std::string name = file.path().filename().string();
        std::smatch       parts;
        if (std::regex_match(name, parts, names) &&
            std::stoul(parts[2]) >= n_sets)
          newer.push_back(file.path());
      }
    for (const fs::path &file : newer)
      fs::remove(file);
    if (!grid_files.empty())
      write_collection(folder->path("grid.pvd"), grid_files);
    if (!point_files.empty())
      write_collection(folder->path("points.pvd"), point_files);
  }



  template <int dim>
  void
  Fields<dim>::write_grid(const std::string                 &name,
                          const Grid::Space<dim>            &space,
                          const std::vector<double>         &solution,
                          const Points::MaterialPoints<dim> &points) const
  {
    // The deformed grid: nodal positions X + u, with ghosts. A grid through
    // which points move is where it has been put back to.
    LinearAlgebra::Vector positions = space.owned_vector();
    LinearAlgebra::Vector values    = space.owned_vector();
    for (const auto dof : space.owned())
      {
        const unsigned int i = space.local(dof);
        const unsigned int c = space.components()[i];
        values(dof)          = solution[i];
        if (c < dim)
          positions(dof) = points.are_moving() ?
                             space.frame().to_space(space.nodes()[i])[c] :
                             space.nodes()[i][c] + solution[i];
      }
    values.compress(dealii::VectorOperation::insert);
    positions.compress(dealii::VectorOperation::insert);
    LinearAlgebra::Vector ghosted_positions(space.owned(),
                                            space.relevant(),
                                            space.communicator());
    LinearAlgebra::Vector ghosted_values(ghosted_positions);
    ghosted_positions = positions;
    ghosted_values    = values;

    dealii::ComponentMask mask(space.n_components(), false);
    for (unsigned int d = 0; d < dim; ++d)
      mask.set(d, true);
    const dealii::MappingFEField<dim, dim, LinearAlgebra::Vector> mapping(
      space.dof_handler(), ghosted_positions, mask);

    std::vector<std::string>    names(dim, "displacement(m)");
    std::vector<Interpretation> interpretations(
      dim, dealii::DataComponentInterpretation::component_is_part_of_vector);
    if (space.is_micropolar())
      for (unsigned int k = 0; k < Grid::Space<dim>::n_spin; ++k)
        {
          names.push_back(dim == 2 ? "micro_rotation(rad)" :
                                     "micro_rotation_" + std::to_string(k + 1) +
                                       "(rad)");
          interpretations.push_back(
            dealii::DataComponentInterpretation::component_is_scalar);
        }

    dealii::DataOut<dim> out;
    out.attach_dof_handler(space.dof_handler());
    out.set_cell_selection([&points](const auto &cell) {
      return cell->is_active() && cell->is_locally_owned() &&
             points.particles().n_particles_in_cell(cell) > 0;
    });
    out.add_data_vector(ghosted_values,
                        names,
                        dealii::DataOut<dim>::type_dof_data,
                        interpretations);

    const PointFields fields(points.layout());
    const auto        means =
      cell_means(space.dof_handler().get_triangulation(), points, fields);
    unsigned int i = 0;
    for (const auto &field : fields.fields())
      for (unsigned int c = 0; c < field.components.size(); ++c, ++i)
        // what the nodes already say is not repeated
        if (field.name != "displacement" && field.name != "micro_rotation")
          out.add_data_vector(means[i],
                              field.file_name(c),
                              dealii::DataOut<dim>::type_cell_data);

    dealii::DataOutBase::VtkFlags flags;
    flags.write_higher_order_cells = false;
    flags.compression_level        = compression;
    out.set_flags(flags);
    out.build_patches(mapping,
                      space.element().degree,
                      dealii::DataOut<dim>::curved_inner_cells);
    out.write_vtu_in_parallel(name, space.communicator());
  }



  template <int dim>
  void
  Fields<dim>::write_points(const std::string                 &name,
                            const double                       load,
                            const MPI_Comm                     communicator,
                            const Points::MaterialPoints<dim> &points) const
  {
    const PointFields             fields(points.layout());
    PointPatches<dim>             patches(points, fields);
    dealii::DataOutBase::VtkFlags flags;
    flags.compression_level = compression;
    patches.set_flags(flags);
    patches.write_vtu_in_parallel(name + ".vtu", communicator);

    // Rows of this rank in the file.
    const hsize_t n_here = points.n_points();
    hsize_t       first  = 0;
    const int     code   = MPI_Exscan(
      &n_here, &first, 1, MPI_UNSIGNED_LONG_LONG, MPI_SUM, communicator);
    AssertThrowMPI(code);
    static_assert(sizeof(hsize_t) == sizeof(unsigned long long));
    const hsize_t n_all =
      dealii::Utilities::MPI::sum(static_cast<unsigned long long>(n_here),
                                  communicator);

    dealii::HDF5::File file(name + ".h5",
                            dealii::HDF5::File::FileAccessMode::create,
                            communicator);
    file.set_attribute("load", load);
    const auto write_column = [&](const std::string         &dataset_name,
                                  const std::string         &unit,
                                  const std::vector<double> &column) {
      auto dataset = file.create_dataset<double>(dataset_name, {n_all});
      dataset.set_attribute("unit", unit);
      if (n_here > 0)
        dataset.write_hyperslab(column, {first}, {n_here});
      else
        dataset.template write_none<double>();
    };

    std::vector<std::vector<double>> columns(fields.n_values(),
                                             std::vector<double>(n_here));
    std::vector<std::vector<double>> position(dim, std::vector<double>(n_here));
    std::vector<double>              id(n_here), values(fields.n_values());
    for (unsigned int p = 0; p < n_here; ++p)
      {
        const double *row = points.row(p);
        id[p]             = static_cast<double>(points.id(p));
        for (unsigned int d = 0; d < dim; ++d)
          position[d][p] = points.position(p)[d];
        fields.evaluate(row, values.data());
        for (unsigned int i = 0; i < values.size(); ++i)
          columns[i][p] = values[i];
      }
    write_column("id", "1", id);
    for (unsigned int d = 0; d < dim; ++d)
      write_column("position_" + std::to_string(d + 1), "m", position[d]);
    unsigned int i = 0;
    for (const auto &field : fields.fields())
      for (const auto &component : field.components)
        write_column(field.name + (component.empty() ? "" : "_") + component,
                     field.unit,
                     columns[i++]);
  }



  template class Fields<2>;
  template class Fields<3>;
} // namespace Riedel::Output
