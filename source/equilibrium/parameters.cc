// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/parameters.h>
#include <riedel/nearest_name.h>
#include <riedel/pattern.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace Riedel::Equilibrium
{
  using dealii::ParameterHandler;
  namespace Patterns = dealii::Patterns;

  namespace
  {
    /// The names of the components of a vector.
    template <int dim>
    std::string
    component(const std::string &name, const unsigned int d)
    {
      return name + " " + std::to_string(d + 1);
    }

    /// In the plane there is one rotation, without a number.
    template <int dim>
    std::string
    spin(const std::string &name, const unsigned int d)
    {
      return dim == 2 ? name : component<dim>(name, d);
    }

    template <int dim>
    void
    declare_formula(ParameterHandler  &prm,
                    const std::string &name,
                    const std::string &documentation)
    {
      prm.declare_entry(name,
                        "",
                        FormPattern(std::string("a number or a formula in ") +
                                    (dim == 2 ? "x, y" : "x, y, z") +
                                    " [m] and s"),
                        documentation);
    }

    template <int dim>
    Expression<dim>
    read_formula(ParameterHandler  &prm,
                 const std::string &section,
                 const std::string &name)
    {
      try
        {
          return Expression<dim>(prm.get(name));
        }
      catch (const std::invalid_argument &reason)
        {
          throw ParameterError(section + "/" + name, reason.what());
        }
    }
  } // namespace



  template <int dim>
  void
  BoundaryConditionParameters<dim>::declare(
    ParameterHandler               &prm,
    const std::vector<std::string> &names)
  {
    prm.enter_subsection("Boundary conditions");
    for (const std::string &name : names)
      {
        prm.enter_subsection(name);
        for (unsigned int d = 0; d < dim; ++d)
          declare_formula<dim>(
            prm,
            component<dim>("Displacement", d),
            "Prescribed displacement [m]; free if not given.");
        for (unsigned int d = 0; d < BoundaryParameters<dim>::n_spin; ++d)
          declare_formula<dim>(prm,
                               spin<dim>("Rotation", d),
                               "Prescribed micro-rotation [rad], positive "
                               "counterclockwise; free if not given.");
        declare_formula<dim>(
          prm,
          "Pressure",
          "Pressure on the surface, compression positive [Pa].");
        for (unsigned int d = 0; d < dim; ++d)
          declare_formula<dim>(prm,
                               component<dim>("Traction", d),
                               "Force per area of the surface [Pa].");
        for (unsigned int d = 0; d < BoundaryParameters<dim>::n_spin; ++d)
          declare_formula<dim>(prm,
                               spin<dim>("Couple traction", d),
                               "Couple per area of the surface [N/m].");
        prm.declare_entry("Pressure acts on",
                          "current area",
                          Patterns::Selection("initial area|current area"),
                          "The area that pressure, traction and couple "
                          "traction refer to. On the initial area they are "
                          "dead loads: the total force stays.");
        prm.declare_entry("Load form",
                          "automatic",
                          Patterns::Selection(
                            "automatic|surface integral|virtual stress"),
                          "How the pressure enters the equations: integrated "
                          "over the faces of the boundary, or as a virtual "
                          "stress field in the body; automatic is the first, "
                          "and the second in the configuration current.");
        prm.leave_subsection();
      }
    prm.leave_subsection();
  }



  template <int dim>
  void
  BoundaryConditionParameters<dim>::parse(ParameterHandler               &prm,
                                          const std::vector<std::string> &names)
  {
    boundaries.clear();
    prm.enter_subsection("Boundary conditions");
    for (const std::string &name : names)
      {
        const std::string section = "Boundary conditions/" + name;
        prm.enter_subsection(name);
        BoundaryParameters<dim> boundary;
        boundary.name = name;
        for (unsigned int d = 0; d < dim; ++d)
          {
            boundary.displacement[d] =
              read_formula<dim>(prm,
                                section,
                                component<dim>("Displacement", d));
            boundary.traction[d] =
              read_formula<dim>(prm, section, component<dim>("Traction", d));
          }
        for (unsigned int d = 0; d < BoundaryParameters<dim>::n_spin; ++d)
          {
            boundary.rotation[d] =
              read_formula<dim>(prm, section, spin<dim>("Rotation", d));
            boundary.couple_traction[d] =
              read_formula<dim>(prm, section, spin<dim>("Couple traction", d));
          }
        boundary.pressure      = read_formula<dim>(prm, section, "Pressure");
        boundary.area          = prm.get("Pressure acts on") == "initial area" ?
                                   LoadArea::initial :
                                   LoadArea::current;
        const std::string form = prm.get("Load form");
        boundary.form = form == "virtual stress" ? LoadForm::virtual_stress :
                        form == "automatic"      ? LoadForm::automatic :
                                                   LoadForm::surface_integral;
        boundaries.push_back(boundary);
        prm.leave_subsection();
      }
    prm.leave_subsection();
  }



  template <int dim>
  void
  BoundaryConditionParameters<dim>::choose_form(const LoadForm form)
  {
    for (auto &boundary : boundaries)
      if (boundary.form == LoadForm::automatic)
        boundary.form = form;
  }



  template <int dim>
  void
  BoundaryConditionParameters<dim>::check(const std::vector<std::string> &known,
                                          const bool micropolar,
                                          Problems  &problems) const
  {
    const std::string no_rotations =
      "No law of this scene has micro-rotations; remove it, or choose a polar "
      "law.";

    std::array<bool, dim> held{};
    for (const BoundaryParameters<dim> &boundary : boundaries)
      {
        const std::string section = "Boundary conditions/" + boundary.name;
        if (std::find(known.begin(), known.end(), boundary.name) == known.end())
          problems.error(section,
                         "The body has no boundary \"" + boundary.name + "\"." +
                           did_you_mean(boundary.name, known) +
                           "\nIts boundaries are: " + enumerate(known) + ".");

        for (unsigned int d = 0; d < dim; ++d)
          {
            held[d] = held[d] || boundary.displacement[d].given();
            if (boundary.displacement[d].given() &&
                boundary.traction[d].given())
              problems.error(section + "/" + component<dim>("Traction", d),
                             "It has no effect where " +
                               component<dim>("Displacement", d) +
                               " is prescribed. Remove one of the two.");
          }
        for (unsigned int d = 0; d < BoundaryParameters<dim>::n_spin; ++d)
          {
            const std::string rotation = spin<dim>("Rotation", d);
            const std::string couple   = spin<dim>("Couple traction", d);
            if (!micropolar && boundary.rotation[d].given())
              problems.error(section + "/" + rotation, no_rotations);
            if (!micropolar && boundary.couple_traction[d].given())
              problems.error(section + "/" + couple, no_rotations);
            if (boundary.rotation[d].given() &&
                boundary.couple_traction[d].given())
              problems.error(section + "/" + couple,
                             "It has no effect where " + rotation +
                               " is prescribed. Remove one of the two.");
          }

        if (boundary.form == LoadForm::virtual_stress)
          {
            bool other_loads = false;
            for (const Expression<dim> &load : boundary.traction)
              other_loads = other_loads || load.given();
            for (const Expression<dim> &load : boundary.couple_traction)
              other_loads = other_loads || load.given();
            if (other_loads)
              problems.error(section + "/Load form",
                             "Only a Pressure has a virtual stress; tractions "
                             "need \"surface integral\".");
          }
      }

    for (unsigned int d = 0; d < dim; ++d)
      if (!held[d])
        problems.error("Boundary conditions",
                       "No boundary prescribes " +
                         component<dim>("Displacement", d) +
                         ": nothing holds the body in direction " +
                         std::to_string(d + 1) +
                         ". Prescribe it on at least "
                         "one boundary, for example \"set " +
                         component<dim>("Displacement", d) + " = 0\".");
  }



  template <int dim>
  void
  LoadingParameters<dim>::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Loading");
    prm.declare_entry("Start",
                      "0",
                      Patterns::Double(Patterns::Double::min_double_value, 0),
                      "The load parameter s begins here. Below 0 there is a "
                      "stage before the loading, in which formulas in s bring "
                      "the initial state into balance with the loads; one step "
                      "ends at s = 0.");
    prm.declare_entry("Initial step",
                      "0",
                      Patterns::Double(0),
                      "First step of the load parameter s; 0: the largest "
                      "step.");
    prm.declare_entry("Largest step",
                      "0.004",
                      Patterns::Double(0),
                      "Largest step of s.");
    prm.declare_entry("Smallest step",
                      "1e-6",
                      Patterns::Double(0),
                      "The computation ends if it needs a smaller step of s.");
    prm.declare_entry("Stop",
                      "1",
                      Patterns::Double(0),
                      "The load parameter s runs from Start to this value.");
    prm.declare_entry("Fixed steps",
                      "false",
                      Patterns::Bool(),
                      "Every step is the first one: no growth, no cut. Only "
                      "marks (Output/Fields every, s = 0, Stop) shorten a "
                      "step.");
    if (dim == 2)
      prm.declare_entry("Strain 33",
                        "",
                        FormPattern("a number or a formula in s"),
                        "Logarithmic strain across the plane since the start, "
                        "extension positive, the same in the whole body "
                        "(generalised plane strain); plane strain if not "
                        "given. Forces per metre are then those per metre of "
                        "the present thickness; for the configuration "
                        "initial.");
    OpeningParameters<dim>::declare(prm);
    for (unsigned int d = 0; d < dim; ++d)
      declare_formula<dim>(
        prm,
        component<dim>("Body force", d),
        "Force per initial volume [N/m3], besides the weight of "
        "the initial state.");
    for (unsigned int d = 0; d < BoundaryParameters<dim>::n_spin; ++d)
      declare_formula<dim>(prm,
                           spin<dim>("Body couple", d),
                           "Couple per initial volume [N/m2].");
    prm.leave_subsection();
  }



  template <int dim>
  void
  LoadingParameters<dim>::parse(ParameterHandler &prm)
  {
    prm.enter_subsection("Loading");
    start         = prm.get_double("Start");
    initial_step  = prm.get_double("Initial step");
    largest_step  = prm.get_double("Largest step");
    smallest_step = prm.get_double("Smallest step");
    stop          = prm.get_double("Stop");
    fixed_steps   = prm.get_bool("Fixed steps");
    if (dim == 2)
      strain_33 = read_formula<dim>(prm, "Loading", "Strain 33");
    opening.parse(prm);
    for (unsigned int d = 0; d < dim; ++d)
      body_force[d] =
        read_formula<dim>(prm, "Loading", component<dim>("Body force", d));
    for (unsigned int d = 0; d < BoundaryParameters<dim>::n_spin; ++d)
      body_couple[d] =
        read_formula<dim>(prm, "Loading", spin<dim>("Body couple", d));
    prm.leave_subsection();
  }



  template <int dim>
  void
  LoadingParameters<dim>::check(const bool micropolar, Problems &problems) const
  {
    const auto text = [](const double value) {
      std::ostringstream stream;
      stream << value;
      return stream.str();
    };

    if (!(stop > 0.0))
      problems.error("Loading/Stop", "It must be larger than 0.");
    if (!(largest_step > 0.0))
      problems.error("Loading/Largest step", "It must be larger than 0.");
    if (!(smallest_step > 0.0))
      problems.error("Loading/Smallest step", "It must be larger than 0.");
    if (smallest_step > largest_step)
      problems.error("Loading/Smallest step",
                     "The smallest step, " + text(smallest_step) +
                       ", is larger than the largest, " + text(largest_step) +
                       ".");
    if (initial_step > largest_step)
      problems.error("Loading/Initial step",
                     "The initial step, " + text(initial_step) +
                       ", is larger than the largest, " + text(largest_step) +
                       ".");
    if (initial_step > 0.0 && initial_step < smallest_step)
      problems.error("Loading/Initial step",
                     "The initial step, " + text(initial_step) +
                       ", is smaller than the smallest, " +
                       text(smallest_step) + ".");
    if (strain_33.given())
      {
        dealii::Point<dim> elsewhere;
        for (unsigned int d = 0; d < dim; ++d)
          elsewhere[d] = 0.3 + 0.4 * d;
        if (strain_33_at(start) != 0.0)
          problems.error("Loading/Strain 33",
                         "It counts from the start and must be 0 there; at "
                         "s = " +
                           text(start) + " it is " + text(strain_33_at(start)) +
                           ".");
        if (strain_33(elsewhere, stop) != strain_33_at(stop))
          problems.error("Loading/Strain 33",
                         "It is the same in the whole body: a formula in s "
                         "without coordinates.");
      }
    opening.check(problems);
    if (opening.controls && start < 0.0)
      problems.error("Loading/Start",
                     "With Control = opening it must be 0: an opening has no "
                     "stage before the loading.");
    for (unsigned int d = 0; d < BoundaryParameters<dim>::n_spin; ++d)
      if (!micropolar && body_couple[d].given())
        problems.error("Loading/" + spin<dim>("Body couple", d),
                       "No law of this scene has micro-rotations; remove it, "
                       "or choose a polar law.");
  }



  void
  SolverParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Solver");
    prm.declare_entry("Scheme",
                      "accelerated",
                      Patterns::Selection("accelerated|newton"),
                      "\"accelerated\" keeps a factor of the tangent over "
                      "iterations and steps and accelerates with secant "
                      "pairs; \"newton\" factors the consistent tangent in "
                      "every iteration and searches along the line.");
    prm.declare_entry("Predictor",
                      "automatic",
                      Patterns::Selection("automatic|quadratic|previous"),
                      "First guess of a step: a parabola through the last "
                      "steps, or the previous increment, scaled; automatic is "
                      "quadratic for accelerated, previous for newton.");
    prm.declare_entry("Linear solver",
                      "automatic",
                      Patterns::Selection("automatic|direct|iterative"),
                      "What solves the linear systems: factors (Direct "
                      "solver), or GMRES with algebraic multigrid, for equal "
                      "degrees of displacement and rotation. Automatic is "
                      "iterative in space above 5000 unknowns.");
    prm.declare_entry("Linear residual",
                      "1e-3",
                      Patterns::Double(0, 1),
                      "To this share of its first value the iterative solver "
                      "reduces the residual of a linear system.");
    prm.declare_entry("Most linear iterations",
                      "300",
                      Patterns::Integer(1),
                      "The iterative solver leaves a system after so many "
                      "iterations as it is.");
    prm.declare_entry("Direct solver",
                      "mumps",
                      Patterns::Selection("mumps|umfpack"),
                      "Library for the linear systems; umfpack works on one "
                      "rank only.");
    prm.declare_entry("Residual",
                      "1e-6",
                      Patterns::Double(0, 1),
                      "Largest residual, relative to the norm of the "
                      "reactions; moments are divided by the law's length.");
    prm.declare_entry("Most iterations",
                      "25",
                      Patterns::Integer(1),
                      "A step that needs more iterations is cut.");
    prm.declare_entry("Target iterations",
                      "7",
                      Patterns::Integer(1),
                      "The step size is adapted to this number of iterations.");
    prm.declare_entry("Refactor after",
                      "16",
                      Patterns::Integer(1),
                      "Iterations with one factor in one step, for "
                      "accelerated.");
    prm.declare_entry("Patience",
                      "30",
                      Patterns::Double(0),
                      "A new factor is made if, at the last rate of "
                      "convergence, more than this number of further "
                      "iterations would be needed, for accelerated.");
    prm.declare_entry("Secant pairs",
                      "10",
                      Patterns::Integer(0, 100),
                      "Pairs of past iterates that the acceleration uses; 0 "
                      "is the modified Newton method.");
    prm.leave_subsection();
  }



  void
  SolverParameters::parse(ParameterHandler &prm)
  {
    prm.enter_subsection("Solver");
    scheme = prm.get("Scheme") == "newton" ? SchemeName::newton :
                                             SchemeName::accelerated;
    const std::string guess = prm.get("Predictor");
    predictor               = guess == "quadratic" ? Predictor::quadratic :
                              guess == "previous"  ? Predictor::previous :
                                                     Predictor::automatic;
    solver = prm.get("Direct solver") == "umfpack" ? DirectSolverName::umfpack :
                                                     DirectSolverName::mumps;
    const std::string linear = prm.get("Linear solver");
    linear_solver            = linear == "direct" ? LinearSolverName::direct :
                               linear == "iterative" ? LinearSolverName::iterative :
                                                       LinearSolverName::automatic;
    linear_residual          = prm.get_double("Linear residual");
    most_linear_iterations   = prm.get_integer("Most linear iterations");
    residual                 = prm.get_double("Residual");
    most_iterations          = prm.get_integer("Most iterations");
    target_iterations        = prm.get_integer("Target iterations");
    refactor_after           = prm.get_integer("Refactor after");
    patience                 = prm.get_double("Patience");
    secant_pairs             = prm.get_integer("Secant pairs");
    prm.leave_subsection();
  }



  void
  SolverParameters::check(Problems &problems) const
  {
    if (!(residual > 0.0))
      problems.error("Solver/Residual", "It must be larger than 0.");
    else if (residual > 1e-3)
      problems.warning("Solver/Residual",
                       "With a residual above 1e-3 the forces are hardly in "
                       "equilibrium.");
    if (!(linear_residual > 0.0))
      problems.error("Solver/Linear residual", "It must be larger than 0.");
    if (target_iterations > most_iterations)
      problems.error("Solver/Target iterations",
                     "The target, " + std::to_string(target_iterations) +
                       ", is more than Most iterations, " +
                       std::to_string(most_iterations) + ".");
  }



  template struct BoundaryConditionParameters<2>;
  template struct LoadingParameters<2>;
  template struct BoundaryConditionParameters<3>;
  template struct LoadingParameters<3>;
} // namespace Riedel::Equilibrium
