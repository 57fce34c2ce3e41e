// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/plates.h>
#include <riedel/grid/cell_lattice.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Riedel::Equilibrium
{
  namespace
  {
    /// Points nearer to a plate than this number of box lengths may come into
    /// contact in a step.
    constexpr double reach = 2.0;

    /// Share of the difference between a contact's penetration and that of the
    /// point's box that a step takes up.
    constexpr double uptake = 0.05;

    /// Overlaps of faces below this share of a box's face are rounding.
    constexpr double least_overlap = 1e-6;

    /// Weights below this are rounding: their nodes may be seen by no point.
    constexpr double least_weight = 1e-12;



    unsigned int
    normal_axis(const unsigned int face)
    {
      return face / 2;
    }

    /// +1 if the face looks along its axis, -1 if against it.
    double
    side(const unsigned int face)
    {
      return face % 2 == 0 ? -1.0 : 1.0;
    }
  } // namespace



  template <int dim>
  Plates<dim>::Plates(const PlatesParameters<dim> &parameters,
                      const Grid::Space<dim>      &space,
                      Points::MaterialPoints<dim> &points)
    : parameters(&parameters)
    , space(&space)
    , points(&points)
    , traction_place(points.layout().find("contact_traction"))
    , face_place(points.layout().find("contact_face"))
    , motion(parameters.plates.size())
    , displacement(parameters.plates.size())
    , rate(parameters.plates.size())
    , accepted_rate(parameters.plates.size())
  {}



  template <int dim>
  Material::StateLayout
  Plates<dim>::slots(const PlatesParameters<dim> &parameters)
  {
    Material::StateLayout layout;
    if (!parameters.plates.empty())
      {
        std::vector<std::string> axes;
        for (unsigned int d = 0; d < dim; ++d)
          axes.push_back(std::to_string(d + 1));
        layout.add("contact_traction",
                   "Pa",
                   "traction of a plate on the point",
                   axes);
        layout.add("contact_face",
                   "1",
                   "0 without contact, else 1 + face + " +
                     std::to_string(2 * dim) + " times number of the plate");
      }
    return layout;
  }



  template <int dim>
  typename Plates<dim>::Meeting
  Plates<dim>::meet_at(const unsigned int              face,
                       const dealii::BoundingBox<dim> &plate,
                       const dealii::Point<dim>       &centre,
                       const dealii::Tensor<1, dim>   &half_lengths) const
  {
    const unsigned int n = normal_axis(face);
    Meeting            result;
    result.face = face;
    result.penetration =
      half_lengths[n] + (side(face) > 0.0 ? plate.upper_bound(n) - centre[n] :
                                            centre[n] - plate.lower_bound(n));
    result.area = 1.0;
    for (unsigned int d = 0; d < dim; ++d)
      if (d != n)
        {
          const double overlap =
            std::min(plate.upper_bound(d), centre[d] + half_lengths[d]) -
            std::max(plate.lower_bound(d), centre[d] - half_lengths[d]);
          result.area *=
            overlap > least_overlap * 2.0 * half_lengths[d] ? overlap : 0.0;
        }
    return result;
  }



  template <int dim>
  typename Plates<dim>::Meeting
  Plates<dim>::meet(const dealii::BoundingBox<dim> &plate,
                    const dealii::Point<dim>       &centre,
                    const dealii::Tensor<1, dim>   &half_lengths) const
  {
    Meeting best;
    for (unsigned int face = 0; face < 2 * dim; ++face)
      {
        const Meeting here = meet_at(face, plate, centre, half_lengths);
        if (here.area > 0.0 &&
            (best.area == 0.0 || here.penetration < best.penetration))
          best = here;
      }
    return best;
  }



  template <int dim>
  void
  Plates<dim>::rebuild(const double s)
  {
    contacts.clear();
    if (parameters->plates.empty())
      return;
    const Grid::CellLattice<dim>  lattice(space->dof_handler());
    const Points::BoxWeights<dim> weights(lattice, space->hanging_nodes());
    std::vector<dealii::BoundingBox<dim>> blocks;
    for (unsigned int i = 0; i < parameters->plates.size(); ++i)
      {
        const auto &plate = parameters->plates[i];
        displacement[i]   = plate.motion(s);
        const auto [a, b] = plate.box.get_boundary_points();
        blocks.emplace_back(
          std::make_pair(a + displacement[i], b + displacement[i]));
      }

    for (const auto &range : points->ranges())
      for (unsigned int p = range.first; p < range.last; ++p)
        {
          const double      *row   = points->row(p);
          const auto         x     = points->position(p);
          const auto         h     = points->half_lengths(row);
          const unsigned int known = static_cast<unsigned int>(row[face_place]);

          // a contact stays on its face until the point has left the face
          unsigned int plate = 0;
          Meeting      meeting;
          if (known > 0)
            {
              plate   = (known - 1) / (2 * dim);
              meeting = meet_at((known - 1) % (2 * dim), blocks[plate], x, h);
            }
          const bool continues = meeting.area > 0.0;
          if (!continues)
            for (unsigned int i = 0; i < blocks.size(); ++i)
              {
                const Meeting here = meet(blocks[i], x, h);
                if (here.area > 0.0 && (meeting.area == 0.0 ||
                                        here.penetration > meeting.penetration))
                  {
                    meeting = here;
                    plate   = i;
                  }
              }
          const unsigned int n = normal_axis(meeting.face);
          if (meeting.area == 0.0 || meeting.penetration < -reach * 2.0 * h[n])
            continue;

          Contact contact;
          contact.point  = p;
          contact.plate  = plate;
          contact.face   = meeting.face;
          contact.area   = meeting.area;
          contact.centre = x;
          contact.centre[n] -= side(meeting.face) * h[n];
          contact.stiffness =
            parameters->plates[plate].penalty *
            points->materials().materials[range.material].law->stiffness(
              points->committed(p)) /
            (2.0 * h[n]);

          const double pressure =
            continues ? side(meeting.face) * row[traction_place + n] : 0.0;
          contact.penetration = meeting.penetration;
          if (pressure > 0.0 || meeting.penetration > 0.0)
            {
              const double present = pressure / contact.stiffness;
              contact.penetration =
                present + uptake * (meeting.penetration - present);
            }
          // the one direction of shear in the plane
          contact.shear = continues ? row[traction_place + (n + 1) % dim] : 0.0;
          if (continues)
            for (unsigned int d = 0; d < dim; ++d)
              contact.traction_before[d] = row[traction_place + d];

          auto half_lengths = h;
          for (unsigned int d = 0; d < dim; ++d)
            half_lengths[d] /= space->frame().stretch(d);
          half_lengths[n] = 0.0;
          if (!weights.evaluate(space->frame().to_grid(contact.centre),
                                half_lengths,
                                contact.nodes))
            continue; // outside the grid: no node could take the force
          contact.nodes.erase(std::remove_if(contact.nodes.begin(),
                                             contact.nodes.end(),
                                             [](const auto &node) {
                                               return node.weight <
                                                      least_weight;
                                             }),
                              contact.nodes.end());
          contacts.push_back(contact);
        }
  }



  template <int dim>
  std::vector<std::vector<dealii::types::global_dof_index>>
  Plates<dim>::couplings() const
  {
    std::vector<std::vector<dealii::types::global_dof_index>> result;
    for (const Contact &contact : contacts)
      {
        result.emplace_back();
        for (unsigned int d = 0; d < dim; ++d)
          for (const auto &node : contact.nodes)
            result.back().push_back(node.node + d);
      }
    return result;
  }



  template <int dim>
  void
  Plates<dim>::move(const double from, const double to)
  {
    for (unsigned int i = 0; i < motion.size(); ++i)
      {
        displacement[i] = parameters->plates[i].motion(to);
        motion[i]       = displacement[i] - parameters->plates[i].motion(from);
        if (to > from)
          rate[i] = motion[i] / (to - from);
      }
  }



  template <int dim>
  double
  Plates<dim>::kink() const
  {
    double result = 0.0;
    for (unsigned int i = 0; i < rate.size(); ++i)
      {
        const double largest =
          std::max(rate[i].norm(), accepted_rate[i].norm());
        if (largest > 0.0)
          result =
            std::max(result, (rate[i] - accepted_rate[i]).norm() / largest);
      }
    return result;
  }



  template <int dim>
  void
  Plates<dim>::add_forces(const std::vector<double>            &du,
                          std::vector<double>                  &forces,
                          const typename Loads<dim>::AddMatrix &add_matrix)
  {
    std::vector<dealii::types::global_dof_index> dofs;
    std::vector<double>                          matrix;
    for (Contact &contact : contacts)
      {
        const auto        &plate = parameters->plates[contact.plate];
        const unsigned int n = normal_axis(contact.face), t = (n + 1) % dim;
        const double       out = side(contact.face), k = contact.stiffness;

        contact.motion = 0.0;
        for (const auto &node : contact.nodes)
          for (unsigned int d = 0; d < dim; ++d)
            contact.motion[d] += node.weight * du[space->local(node.node + d)];
        const auto relative = contact.motion - motion[contact.plate];

        const double pressure = k * (contact.penetration - out * relative[n]);
        contact.traction      = 0.0;
        contact.is_sliding    = false;
        contact.is_closed =
          pressure > 0.0 || (is_sticking && contact.penetration > 0.0);
        if (!contact.is_closed)
          continue;
        const double trial = contact.shear - k * relative[t];
        const double most  = plate.friction_coefficient * pressure;
        contact.is_sliding =
          !plate.is_rough && !is_sticking && std::abs(trial) > most;
        contact.traction[n] = out * pressure;
        contact.traction[t] =
          contact.is_sliding ? std::copysign(most, trial) : trial;

        for (const auto &node : contact.nodes)
          for (unsigned int d = 0; d < dim; ++d)
            forces[space->local(node.node + d)] +=
              contact.area * node.weight * contact.traction[d];

        if (add_matrix)
          {
            // minus derivative of the traction with respect to the motion
            dealii::Tensor<2, dim> stiffness;
            stiffness[n][n] = k;
            if (contact.is_sliding)
              stiffness[t][n] =
                std::copysign(plate.friction_coefficient, trial) * out * k;
            else
              stiffness[t][t] = k;

            const unsigned int m = contact.nodes.size();
            dofs.resize(dim * m);
            matrix.resize(dim * m * dim * m);
            for (unsigned int d = 0; d < dim; ++d)
              for (unsigned int a = 0; a < m; ++a)
                {
                  dofs[d * m + a] = contact.nodes[a].node + d;
                  for (unsigned int e = 0; e < dim; ++e)
                    for (unsigned int b = 0; b < m; ++b)
                      matrix[(d * m + a) * dim * m + e * m + b] =
                        contact.area * contact.nodes[a].weight *
                        stiffness[d][e] * contact.nodes[b].weight;
                }
            add_matrix(dofs, matrix);
          }
      }
  }



  template <int dim>
  void
  Plates<dim>::accept()
  {
    if (parameters->plates.empty())
      return;
    accepted_rate = rate;
    for (unsigned int p = 0; p < points->n_points(); ++p)
      {
        points->row(p)[face_place] = 0.0;
        for (unsigned int d = 0; d < dim; ++d)
          points->row(p)[traction_place + d] = 0.0;
      }
    for (const Contact &contact : contacts)
      if (contact.is_closed)
        {
          double *row     = points->row(contact.point);
          row[face_place] = 1 + contact.face + 2 * dim * contact.plate;
          for (unsigned int d = 0; d < dim; ++d)
            row[traction_place + d] = contact.traction[d];
        }
  }



  template <int dim>
  double
  Plates<dim>::work() const
  {
    double sum = 0.0;
    for (const Contact &contact : contacts)
      sum += 0.5 * contact.area *
             ((contact.traction_before + contact.traction) * contact.motion);
    return dealii::Utilities::MPI::sum(sum, space->communicator());
  }



  template <int dim>
  std::vector<typename Plates<dim>::Report>
  Plates<dim>::reports() const
  {
    // of every plate: force, moment, points in contact, points that slide
    constexpr unsigned int n_spin    = Grid::Space<dim>::n_spin;
    constexpr unsigned int n_numbers = dim + n_spin + 2;
    std::vector<double>    numbers(motion.size() * n_numbers, 0.0);
    for (const Contact &contact : contacts)
      if (contact.is_closed)
        {
          double    *here  = &numbers[contact.plate * n_numbers];
          const auto force = contact.area * contact.traction;
          const auto moment =
            Continuum::moment_of(contact.centre + contact.motion, force);
          for (unsigned int d = 0; d < dim; ++d)
            here[d] += force[d];
          for (unsigned int k = 0; k < n_spin; ++k)
            here[dim + k] += moment[k];
          here[dim + n_spin] += 1.0;
          here[dim + n_spin + 1] += contact.is_sliding ? 1.0 : 0.0;
        }
    std::vector<double> sums(numbers.size());
    dealii::Utilities::MPI::sum(numbers, space->communicator(), sums);

    std::vector<Report> result(motion.size());
    for (unsigned int i = 0; i < result.size(); ++i)
      {
        const double *here     = &sums[i * n_numbers];
        result[i].name         = parameters->plates[i].name;
        result[i].displacement = displacement[i];
        for (unsigned int d = 0; d < dim; ++d)
          result[i].force[d] = here[d];
        for (unsigned int k = 0; k < n_spin; ++k)
          result[i].moment[k] = here[dim + k];
        result[i].n_contacts = static_cast<unsigned int>(here[dim + n_spin]);
        result[i].n_sliding = static_cast<unsigned int>(here[dim + n_spin + 1]);
      }
    return result;
  }



  template class Plates<2>;
  template class Plates<3>;
} // namespace Riedel::Equilibrium
