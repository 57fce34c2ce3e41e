// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/loads.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

namespace Riedel::Equilibrium
{
  namespace
  {
    /// The face's own coordinate xi runs along this direction of the cell.
    template <int dim>
    dealii::Tensor<1, dim>
    face_direction(const unsigned int face)
    {
      static_assert(dim == 2, "surface loads on faces are written for 2D");
      dealii::Tensor<1, dim> direction;
      direction[1 - face / 2] = 1.0;
      return direction;
    }



    /// +1 if (t_2, -t_1) points outwards for the tangent t along
    /// face_direction().
    double
    outward_sign(const unsigned int face)
    {
      // left: t = e_y -> (1, 0) points inwards; right: outwards;
      // bottom: t = e_x -> (0, -1) points outwards; top: inwards
      return (face == 0 || face == 3) ? -1.0 : 1.0;
    }
  } // namespace



  template <int dim>
  Loads<dim>::Loads(const BoundaryConditionParameters<dim> &boundaries,
                    const LoadingParameters<dim>           &loading,
                    const Grid::Body<dim>                  &body,
                    const Grid::Space<dim>                 &space,
                    const bool                              body_fills_grid)
    : parameters(&boundaries)
    , loading(&loading)
    , body(&body)
    , space(&space)
    , surface(boundaries.boundaries.size())
  {
    const auto                                  &fe = space.element();
    const dealii::FE_Q<dim>                      geometry(1);
    const dealii::QGauss<1>                      rule(fe.degree + 1);
    std::vector<dealii::types::global_dof_index> cell_dofs(
      fe.n_dofs_per_cell());

    for (unsigned int b = 0; b < boundaries.boundaries.size(); ++b)
      {
        const auto &boundary = boundaries.boundaries[b];
        bool        loaded   = boundary.pressure.given();
        for (const auto &formula : boundary.traction)
          loaded = loaded || formula.given();
        for (const auto &formula : boundary.couple_traction)
          loaded = loaded || formula.given();
        if (!loaded || !body_fills_grid)
          continue;

        const auto id = body.boundary(boundary.name);
        for (const auto &cell : space.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned())
            for (const unsigned int f : cell->face_indices())
              if (cell->face(f)->at_boundary() &&
                  cell->face(f)->boundary_id() == id)
                {
                  const std::size_t first_dof = dofs.size();
                  cell->get_dof_indices(cell_dofs);
                  for (const unsigned int i : space.order_by_component())
                    dofs.push_back(space.local(cell_dofs[i]));

                  const auto direction = face_direction<dim>(f);
                  for (unsigned int q = 0; q < rule.size(); ++q)
                    {
                      dealii::Point<dim> place;
                      place[f / 2]     = f % 2;
                      place[1 - f / 2] = rule.point(q)[0];

                      FacePoint point;
                      point.boundary  = b;
                      point.first_dof = first_dof;
                      point.weight    = rule.weight(q);
                      for (const unsigned int v : cell->vertex_indices())
                        {
                          point.position +=
                            geometry.shape_value(v, place) * cell->vertex(v);
                          point.tangent +=
                            (geometry.shape_grad(v, place) * direction) *
                            cell->vertex(v);
                        }
                      const double sign = outward_sign(f);
                      point.tangent *= sign;
                      const auto &u = fe.base_element(0);
                      for (unsigned int a = 0; a < u.n_dofs_per_cell(); ++a)
                        {
                          point.shape.push_back(u.shape_value(a, place));
                          point.slope.push_back(
                            sign * (u.shape_grad(a, place) * direction));
                        }
                      if (space.is_micropolar())
                        {
                          const auto &w = fe.base_element(1);
                          for (unsigned int a = 0; a < w.n_dofs_per_cell(); ++a)
                            point.rotation_shape.push_back(
                              w.shape_value(a, place));
                        }
                      face_points.push_back(point);
                    }
                }
      }
  }



  template <int dim>
  void
  Loads<dim>::add_body_forces(const Points::Supports<dim>       &supports,
                              const Points::MaterialPoints<dim> &points,
                              const double                       s,
                              std::vector<double>               &forces) const
  {
    constexpr unsigned int up = dim - 1;
    for (const auto &patch : supports.patches)
      for (unsigned int q = 0; q < patch.n_points; ++q)
        {
          const unsigned int p   = patch.first_point + q;
          const double      *row = points.row(p);
          const double       V0  = row[points.place.initial_volume];
          const auto        &X   = points.initial_position(p);

          dealii::Tensor<1, dim> force;
          force[up] = -row[points.place.mass] * Points::gravity;
          for (unsigned int d = 0; d < dim; ++d)
            if (loading->body_force[d].given())
              force[d] += V0 * loading->body_force[d](X, s);

          const double *weight =
            supports.weight.data() + patch.first_weight + q * patch.n_nodes;
          const unsigned int *dof = supports.dofs.data() + patch.first_dof;
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int a = 0; a < patch.n_nodes; ++a)
              forces[dof[d * patch.n_nodes + a]] += force[d] * weight[a];

          if (patch.n_rotation_nodes > 0)
            for (unsigned int k = 0; k < n_spin; ++k)
              if (loading->body_couple[k].given())
                {
                  const double  couple = V0 * loading->body_couple[k](X, s);
                  const double *spin   = supports.spin_weight.data() +
                                       patch.first_rotation_weight +
                                       q * patch.n_rotation_nodes;
                  for (unsigned int a = 0; a < patch.n_rotation_nodes; ++a)
                    forces[dof[dim * patch.n_nodes +
                               k * patch.n_rotation_nodes + a]] +=
                      couple * spin[a];
                }
        }
  }



  template <int dim>
  void
  Loads<dim>::set_extent(const dealii::BoundingBox<dim> &initial,
                         const dealii::BoundingBox<dim> &present)
  {
    has_extent     = true;
    initial_extent = initial;
    present_extent = present;
  }



  template <int dim>
  void
  Loads<dim>::add_sides_of_extent(const double s) const
  {
    static_assert(dim == 2, "the area of a side is written for 2D");
    for (unsigned int b = 0; b < surface.size(); ++b)
      {
        const auto &boundary = parameters->boundaries[b];
        if (!boundary.pressure.given() ||
            dealii::Utilities::MPI::this_mpi_process(space->communicator()) > 0)
          continue; // the sides are summed over the ranks
        const unsigned int id     = body->boundary(boundary.name);
        const unsigned int normal = id / 2, across = 1 - normal;
        const double       sign   = id % 2 == 0 ? -1.0 : 1.0;
        const auto         middle = [&](const auto &extent) {
          dealii::Point<dim> x = extent.center();
          x[normal] = id % 2 == 0 ? extent.lower_bound(normal) :
                                            extent.upper_bound(normal);
          return x;
        };
        auto &side               = surface[b];
        side.normal_area[normal] = sign * present_extent.side_length(across);
        side.initial_normal_area[normal] =
          sign * initial_extent.side_length(across);
        const auto &area = boundary.area == LoadArea::initial ?
                             side.initial_normal_area :
                             side.normal_area;
        side.force       = -boundary.pressure(middle(initial_extent), s) * area;
        const auto x     = middle(present_extent);
        side.moment      = x[0] * side.force[1] - x[1] * side.force[0];
      }
  }



  template <int dim>
  void
  Loads<dim>::add_surface_loads(const std::vector<double> &u,
                                const double               s,
                                std::vector<double>       &forces,
                                const AddMatrix           &add_matrix) const
  {
    surface.assign(surface.size(), Surface());
    if (has_extent)
      add_sides_of_extent(s);
    std::vector<dealii::types::global_dof_index> global;
    std::vector<double>                          matrix;

    for (const FacePoint &point : face_points)
      {
        const auto         &boundary = parameters->boundaries[point.boundary];
        const unsigned int  n        = point.shape.size();
        const unsigned int  nw       = point.rotation_shape.size();
        const unsigned int *dof      = dofs.data() + point.first_dof;
        const bool          follows  = boundary.area == LoadArea::current;

        const auto normal = [](const dealii::Tensor<1, dim> &t) {
          dealii::Tensor<1, dim> result;
          result[0] = t[1];
          result[1] = -t[0];
          return result;
        };
        dealii::Tensor<1, dim> present = point.tangent;
        dealii::Point<dim>     place   = point.position;
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int a = 0; a < n; ++a)
            {
              present[d] += u[dof[d * n + a]] * point.slope[a];
              place[d] += u[dof[d * n + a]] * point.shape[a];
            }
        const dealii::Tensor<1, dim> tangent =
          (follows ? present : point.tangent);
        const double length = tangent.norm();

        // Force and couple per d(xi), and their derivatives with respect to the
        // tangent; of a virtual stress only the force counts here.
        dealii::Tensor<1, dim> force, total, couple_derivative;
        dealii::Tensor<2, dim> derivative;
        double                 couple = 0.0;
        if (boundary.pressure.given())
          {
            const double p = boundary.pressure(point.position, s);
            total -= p * normal(tangent);
            if (boundary.form == LoadForm::surface_integral)
              {
                force -= p * normal(tangent);
                derivative[0][1] -= p;
                derivative[1][0] += p;
              }
          }
        for (unsigned int d = 0; d < dim; ++d)
          if (boundary.traction[d].given())
            {
              const double t = boundary.traction[d](point.position, s);
              force[d] += t * length;
              total[d] += t * length;
              derivative[d] += t / length * tangent;
            }
        if (boundary.couple_traction[0].given() && nw > 0)
          {
            const double m    = boundary.couple_traction[0](point.position, s);
            couple            = m * length;
            couple_derivative = m / length * tangent;
          }

        auto &sum = surface[point.boundary];
        sum.normal_area += point.weight * normal(present);
        sum.initial_normal_area += point.weight * normal(point.tangent);
        sum.force += point.weight * total;
        sum.moment +=
          point.weight * (place[0] * total[1] - place[1] * total[0] + couple);

        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int a = 0; a < n; ++a)
            forces[dof[d * n + a]] += point.weight * force[d] * point.shape[a];
        for (unsigned int a = 0; a < nw; ++a)
          forces[dof[dim * n + a]] +=
            point.weight * couple * point.rotation_shape[a];

        if (add_matrix && follows)
          {
            const unsigned int n_dofs = dim * n + nw;
            global.resize(n_dofs);
            matrix.assign(n_dofs * n_dofs, 0.0);
            for (unsigned int i = 0; i < n_dofs; ++i)
              global[i] = space->relevant().nth_index_in_set(dof[i]);
            for (unsigned int e = 0; e < dim; ++e)
              for (unsigned int b = 0; b < n; ++b)
                {
                  const double       slope  = point.weight * point.slope[b];
                  const unsigned int column = e * n + b;
                  for (unsigned int d = 0; d < dim; ++d)
                    for (unsigned int a = 0; a < n; ++a)
                      matrix[(d * n + a) * n_dofs + column] -=
                        slope * point.shape[a] * derivative[d][e];
                  for (unsigned int a = 0; a < nw; ++a)
                    matrix[(dim * n + a) * n_dofs + column] -=
                      slope * point.rotation_shape[a] * couple_derivative[e];
                }
            add_matrix(global, matrix);
          }
      }
  }



  template class Loads<2>;
} // namespace Riedel::Equilibrium
