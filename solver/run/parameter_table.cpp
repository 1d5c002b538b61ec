// SPDX-License-Identifier: BSD-3-Clause
#include "run/parameter_table.hpp"

#include <type_traits>
#include <utility>

namespace rouleau {
namespace {

void assign(double& member, const TypedValue& v) { member = v.real; }
void assign(int& member, const TypedValue& v) { member = static_cast<int>(v.integer); }
void assign(std::int64_t& member, const TypedValue& v) { member = v.integer; }
void assign(Vec3& member, const TypedValue& v) { member = v.vector; }
void assign(std::filesystem::path& member, const TypedValue& v) { member = v.file; }
template <class E>
requires std::is_enum_v<E>
void assign(E& member, const TypedValue& v) { member = static_cast<E>(v.choice); }

using Store = void (*)(RunParameters&, std::size_t, const TypedValue&);

template <auto section, auto member>
void in(RunParameters& p, std::size_t, const TypedValue& v) {
  assign(p.*section.*member, v);
}
template <auto member>
void in_cell(RunParameters& p, std::size_t cell, const TypedValue& v) {
  assign(p.cells[cell].*member, v);
}

// A row of the table under construction.
struct Row {
  ParameterSpec p;
  Row when(std::string_view selector, std::vector<std::string_view> admitted) && {
    p.conditions.push_back({selector, std::move(admitted)});
    return std::move(*this);
  }
  Row with_cells() && { return std::move(*this).when("cells", {}); }
  Row example(std::string_view text) && {
    p.example = text;
    return std::move(*this);
  }
  Row may_change() && {
    p.kind = ParameterKind::free;
    return std::move(*this);
  }
};

constexpr std::string_view required;
using Choices = std::vector<std::string_view>;

Row row(std::string_view section, std::string_view name, ParameterType type, std::string_view default_text,
        std::pair<double, double> range, Choices choices, Store store, std::string_view help) {
  return {{section,
           name,
           type,
           default_text,
           range.first,
           range.second,
           ParameterKind::identity,
           std::move(choices),
           {},
           {},
           help,
           store}};
}
Row real(std::string_view section, std::string_view name, std::string_view default_text, double min, double max,
         Store store, std::string_view help) {
  return row(section, name, ParameterType::real, default_text, {min, max}, {}, store, help);
}
Row integer(std::string_view section, std::string_view name, std::string_view default_text, double min, double max,
            Store store, std::string_view help) {
  return row(section, name, ParameterType::integer, default_text, {min, max}, {}, store, help);
}
Row vector(std::string_view section, std::string_view name, std::string_view default_text, double min, double max,
           Store store, std::string_view help) {
  return row(section, name, ParameterType::vector, default_text, {min, max}, {}, store, help);
}
Row choice(std::string_view section, std::string_view name, std::string_view default_text, Choices choices, Store store,
           std::string_view help) {
  return row(section, name, ParameterType::choice, default_text, {0, 0}, std::move(choices), store, help);
}
Row file(std::string_view section, std::string_view name, Store store, std::string_view help) {
  return row(section, name, ParameterType::file, required, {0, 0}, {}, store, help);
}

using R = RunParameters;
template <auto member>
constexpr Store fluid = in<&R::fluid, member>;
template <auto member>
constexpr Store channel = in<&R::channel, member>;
template <auto member>
constexpr Store flow = in<&R::flow, member>;
template <auto member>
constexpr Store cell = in_cell<member>;
template <auto member>
constexpr Store membrane = in<&R::membrane, member>;
template <auto member>
constexpr Store stretch = in<&R::stretch, member>;
template <auto member>
constexpr Store numerics = in<&R::numerics, member>;
template <auto member>
constexpr Store output = in<&R::output, member>;
template <auto member>
constexpr Store bounds = in<&R::bounds, member>;

using Rows = std::vector<Row>;

Rows fluid_rows() {
  using P = FluidParameters;
  return {
      real("fluid", "lambda", "5", 0.1, 100, fluid<&P::lambda>, "viscosity contrast: inside / plasma")
          .with_cells()
          .example("5"),
      real("fluid", "plasma_viscosity_mPa_s", "1.2", 0.01, 1000, fluid<&P::plasma_viscosity_mPa_s>,
           "viscosity of the plasma"),
      real("fluid", "density_kg_per_m3", "1000", 1, 20000, fluid<&P::density_kg_per_m3>,
           "density of both fluids; enters only the physical Reynolds number"),
  };
}

Rows channel_rows() {
  using P = ChannelParameters;
  return {
      real("channel", "length_x_um", required, 0.1, 1e5, channel<&P::length_x_um>,
           "along the flow, periodic; a whole number of node spacings, like the other two")
          .example("21"),
      real("channel", "length_y_um", required, 0.1, 1e5, channel<&P::length_y_um>, "width").example("12"),
      real("channel", "length_z_um", required, 0.1, 1e5, channel<&P::length_z_um>, "height").example("10"),
      choice("channel", "boundary_y", "wall", {"wall", "periodic"}, channel<&P::boundary_y>, "the two y faces"),
      choice("channel", "boundary_z", "wall", {"wall", "periodic"}, channel<&P::boundary_z>, "the two z faces"),
  };
}

Rows flow_rows() {
  using P = FlowParameters;
  return {
      choice("flow", "driving", "mean_velocity", {"mean_velocity", "pressure_gradient", "shear", "rest"},
             flow<&P::driving>, "a held mean velocity, a fixed pressure gradient, z walls moving in +-x, or nothing"),
      real("flow", "mean_velocity_mm_per_s", required, 1e-6, 1e4, flow<&P::mean_velocity_mm_per_s>,
           "mean velocity over the cross-section, held by a controller")
          .when("driving", {"mean_velocity"})
          .example("1.5"),
      real("flow", "pressure_gradient_Pa_per_m", required, 1e-3, 1e10, flow<&P::pressure_gradient_Pa_per_m>,
           "-dp/dx; the cell slows the flow by some percent")
          .when("driving", {"pressure_gradient"})
          .example("4.33424e5"),
      real("flow", "shear_rate_per_s", required, 1e-3, 1e7, flow<&P::shear_rate_per_s>,
           "velocity difference of the z walls over their distance")
          .when("driving", {"shear"})
          .example("100"),
      choice("flow", "initial", "rest", {"rest", "developed", "uniform"}, flow<&P::initial>,
             "flow at the start; uniform: plug flow in a box without walls"),
      real("flow", "initial_velocity_mm_per_s", required, 1e-6, 1e4, flow<&P::initial_velocity_mm_per_s>,
           "of the plug flow, along x")
          .when("initial", {"uniform"})
          .example("1.5"),
  };
}

Rows cell_rows() {
  using P = CellParameters;
  const Choices generated{"red_blood_cell", "sphere", "ellipsoid"};
  return {
      choice("cell", "shape", "red_blood_cell", {"red_blood_cell", "sphere", "ellipsoid", "mesh", "checkpoint", "none"},
             cell<&P::shape>,
             "the shape at the start; mesh: OFF or STL file in um; checkpoint: a deformed cell of another run"),
      real("cell", "radius_um", "4", 0.05, 1000, cell<&P::radius_um>, "of the sphere, or R of the red blood cell")
          .when("shape", {"red_blood_cell", "sphere"}),
      vector("cell", "semi_axes_um", required, 0.05, 1000, cell<&P::semi_axes_um>, "of the ellipsoid, before rotation")
          .when("shape", {"ellipsoid"})
          .example("4 4 1.3"),
      integer("cell", "subdivisions", "4", 2, 5, cell<&P::subdivisions>,
              "of the icosahedron: 20 4^n triangles; the mean edge should be 0.4 to 1.2 node spacings")
          .when("shape", generated),
      integer("cell", "frequency", required, 4, 32, cell<&P::frequency>,
              "of the icosahedron, instead of subdivisions: 20 n^2 triangles; default: 2^subdivisions")
          .when("shape", generated)
          .example("8"),
      file("cell", "mesh_file", cell<&P::mesh_file>, "relative to the run file's folder")
          .when("shape", {"mesh", "checkpoint"})
          .example("cell.off"),
      integer("cell", "mesh_cell", "0", 0, 1e6, cell<&P::mesh_cell>, "which cell of the checkpoint")
          .when("shape", {"checkpoint"}),
      choice(
          "cell", "offset_from", "axis", {"axis", "checkpoint"}, cell<&P::offset_from>,
          "the two offsets count from the channel axis, or from where the checkpoint has the cell across the channel")
          .when("shape", {"checkpoint"}),
      real("cell", "scale", "1", 1e-9, 1e9, cell<&P::scale>, "factor on the shape's size").with_cells(),
      real("cell", "offset_y_um", "0", -1e5, 1e5, cell<&P::offset_y_um>, "of the centre from the channel axis")
          .with_cells()
          .example("0.8"),
      real("cell", "offset_z_um", "0", -1e5, 1e5, cell<&P::offset_z_um>, "of the centre from the channel axis")
          .with_cells()
          .example("0.5"),
      real("cell", "position_x_um", required, 0, 1e5, cell<&P::position_x_um>,
           "of the centre from the periodic seam; default: half of length_x_um")
          .with_cells()
          .example("10.5"),
      vector("cell", "rotation_axis", "0 1 0", -1e6, 1e6, cell<&P::rotation_axis>, "any length but zero").with_cells(),
      real("cell", "rotation_angle_deg", "0", -360, 360, cell<&P::rotation_angle_deg>,
           "0 leaves the disc axis along z; 90 about y puts it along the flow")
          .with_cells(),
      choice("cell", "reference", "initial", {"initial", "file"}, cell<&P::reference>,
             "the stress-free shape: the one at the start, or a file's")
          .with_cells(),
      file("cell", "reference_file", cell<&P::reference_file>,
           "same triangles as the shape; relative to the run file's folder")
          .with_cells()
          .when("reference", {"file"})
          .example("rest.off"),
      real("cell", "jitter_um", "0", 0, 1000, cell<&P::jitter_um>,
           "half side of the cube in which a replica's start is displaced")
          .with_cells(),
      integer("cell", "replica", "0", 0, 1e9, cell<&P::replica>, "seeds the displacement; 0: none").with_cells(),
  };
}

Rows membrane_rows() {
  using P = MembraneParameters;
  return {
      choice("membrane", "law", "skalak", {"skalak", "neo_hookean"}, membrane<&P::law>,
             "how the membrane resists strain in its plane; neo_hookean: G_s/2 (l1^2 + l2^2 + 1/(l1 l2)^2 - 3)")
          .with_cells(),
      real("membrane", "shear_modulus_uN_per_m", "5", 1e-6, 1e6, membrane<&P::shear_modulus_uN_per_m>,
           "shear modulus in the convention below")
          .with_cells(),
      choice("membrane", "shear_modulus_convention", "kappa_S", {"kappa_S", "G_s", "B"},
             membrane<&P::shear_modulus_convention>,
             "prefactor of Skalak's energy: kappa_S/12, G_s/4, or the paper's B/4; kappa_S = 3 G_s = 1.5 B")
          .with_cells(),
      real("membrane", "area_ratio", "100", 0, 1e5, membrane<&P::area_ratio>,
           "C = kappa_A / kappa_S, the same number in all three conventions")
          .with_cells()
          .when("law", {"skalak"}),
      real("membrane", "bending_modulus_J", "3e-19", 0, 1e-12, membrane<&P::bending_modulus_J>,
           "kappa_B of E = 2 kappa_B int H^2 dS")
          .with_cells(),
  };
}

Rows stretch_rows() {
  using P = StretchParameters;
  const Choices axes{"x", "y", "z"};
  return {
      choice("stretch", "axis", "none", {"none", "x", "y", "z"}, stretch<&P::axis>,
             "pulls the two ends of each cell apart along this axis, as optical tweezers do; none: no such forces")
          .with_cells(),
      real("stretch", "force_pN", required, 0, 1e6, stretch<&P::force_pN>,
           "total force on each end, shared equally by its vertices")
          .with_cells()
          .when("axis", axes)
          .example("50"),
      real("stretch", "share", "0.05", 1e-4, 0.5, stretch<&P::share>,
           "of the cell's vertices at each end: those that lie farthest out along the axis at the start")
          .with_cells()
          .when("axis", axes),
      real("stretch", "ramp_ms", "0", 0, 1e6, stretch<&P::ramp_ms>,
           "time in which the force rises, smoothly; 0: at once")
          .with_cells()
          .when("axis", axes),
  };
}

Rows numerics_rows() {
  using P = NumericsParameters;
  const Choices tracked{"vertex_normals", "vertex_normals_wide", "face_normals"};
  return {
      real("numerics", "node_spacing_um", required, 1e-3, 100, numerics<&P::node_spacing_um>,
           "dx; a transition study needs 1/3 or finer")
          .example("1/2"),
      real("numerics", "time_step_us", required, 1e-6, 1e4, numerics<&P::time_step_us>,
           "dt; with dx and tau it sets the inflation of the Reynolds number, see `check`")
          .example("25/36"),
      real("numerics", "tau_plasma", "1", 0.51, 6, numerics<&P::tau_plasma>,
           "relaxation time outside; inside 0.5 + lambda (tau - 0.5)")
          .example("1.5"),
      choice("numerics", "precision", "single", {"single", "double"}, numerics<&P::precision>, "of the populations"),
      choice("numerics", "collision", "trt", {"trt", "mrt"}, numerics<&P::collision>,
             "trt: the two-rate case of mrt, exact walls at magic_lambda = 3/16"),
      real("numerics", "magic_lambda", "3/16", 1e-3, 10, numerics<&P::magic_lambda>, "held in both fluids")
          .when("collision", {"trt"}),
      real("numerics", "omega_e", "1", 0.01, 1.99, numerics<&P::omega_e>, "rate of the energy")
          .when("collision", {"mrt"}),
      real("numerics", "omega_eps", "1", 0.01, 1.99, numerics<&P::omega_eps>, "rate of the energy squared")
          .when("collision", {"mrt"}),
      real("numerics", "omega_q", "1", 0.01, 1.99, numerics<&P::omega_q>, "rate of the energy flux")
          .when("collision", {"mrt"}),
      real("numerics", "omega_pi", "1", 0.01, 1.99, numerics<&P::omega_pi>, "rate of the fourth-order stress")
          .when("collision", {"mrt"}),
      real("numerics", "omega_m", "1", 0.01, 1.99, numerics<&P::omega_m>, "rate of the third-order moments")
          .when("collision", {"mrt"}),
      choice("numerics", "kernel", "4-point", {"2-point", "3-point", "4-point"}, numerics<&P::kernel>,
             "of spreading and interpolation; 2-point: the paper's; 2- and 3-point need advection = averaged")
          .with_cells(),
      real("numerics", "mesh_mobility", "0.1", 0, 0.3, numerics<&P::mesh_mobility>,
           "share of the vertices' answer to the mesh's shortest waves that the kernel hides and that they get back; "
           "0: the paper's way, in which triangles collapse and fold sooner or later"),
      real("numerics", "fold_resistance", "2", 0, 100, numerics<&P::fold_resistance>,
           "energy, in kappa_B, of edges sharper than 60 degrees, without bound where they fold flat; 0: the paper's "
           "way, in which a rim narrower than an edge closes like a book"),
      choice("numerics", "advection", "euler", {"euler", "adams_bashforth", "averaged"}, numerics<&P::advection>,
             "of the vertices; averaged: by the mean velocity of two steps, which the 2- and 3-point kernels need")
          .with_cells(),
      choice("numerics", "tracking", "face_normals", {"vertex_normals", "vertex_normals_wide", "face_normals", "off"},
             numerics<&P::tracking>,
             "inside/outside update: by vertices with r_shell = 1 or 2, or by faces (fewest wrong flags); off needs "
             "lambda = 1")
          .with_cells(),
      integer("numerics", "correction_interval", "500", 0, 1e9, numerics<&P::correction_interval>,
              "steps between corrections of the inside flags; 0: never")
          .with_cells()
          .when("tracking", tracked),
  };
}

Rows free_rows() {
  using O = OutputParameters;
  using B = BoundsParameters;
  return {
      real("time", "end_time_s", required, 1e-9, 1e6, in<&R::time, &TimeParameters::end_time_s>,
           "physical time to reach")
          .example("0.2"),
      integer("output", "sample_interval_steps", "100", 1, 1e12, output<&O::sample_interval_steps>,
              "steps between lines of samples.csv"),
      real("output", "progress_interval_s", "5", 0.1, 86400, output<&O::progress_interval_s>,
           "wall-clock time between updates of progress.json"),
      real("output", "checkpoint_interval_min", "10", 1e-4, 1e5, output<&O::checkpoint_interval_min>,
           "wall-clock time between checkpoints"),
      integer("output", "checkpoints_kept", "3", 2, 1000, output<&O::checkpoints_kept>, "the newest n"),
      real("output", "snapshot_interval_s", "0", 0, 1e6, output<&O::snapshot_interval_s>,
           "physical time between snapshots of fields and cells, for ParaView; 0: none"),
      real("output", "cell_snapshot_interval_s", "0", 0, 1e6, output<&O::cell_snapshot_interval_s>,
           "physical time between snapshots of the cells alone, which are small; 0: with the fields only")
          .with_cells(),
      integer("output", "snapshot_stride", "1", 1, 1000, output<&O::snapshot_stride>,
              "the fields of a snapshot at every n-th node along each axis"),
      choice("bounds", "unsafe_combination", "refuse", {"refuse", "run"}, bounds<&B::unsafe_combination>,
             "what to do with a kernel and a stiffness that trial runs lost at once"),
      real("bounds", "area_ratio_min", "0.7", 0.01, 1, bounds<&B::area_ratio_min>,
           "A/A0 below this ends the run with exit code 70, like the others here"),
      real("bounds", "area_ratio_max", "1.5", 1, 100, bounds<&B::area_ratio_max>, "A/A0 above this"),
      real("bounds", "inside_ratio_min", "0.7", 0.01, 1, bounds<&B::inside_ratio_min>,
           "volume of the inside nodes / V below this"),
      real("bounds", "inside_ratio_max", "1.3", 1, 100, bounds<&B::inside_ratio_max>,
           "volume of the inside nodes / V above this"),
      real("bounds", "max_mach", "0.1", 1e-4, 0.3, bounds<&B::max_mach>, "largest velocity / lattice speed of sound"),
  };
}

std::vector<ParameterSpec> make_table() {
  std::vector<ParameterSpec> table;
  for (auto* rows : {fluid_rows, channel_rows, flow_rows, cell_rows, membrane_rows, stretch_rows, numerics_rows})
    for (Row& r : rows()) table.push_back(std::move(r.p));
  for (Row& r : free_rows()) table.push_back(std::move(std::move(r).may_change().p));
  return table;
}

}  // namespace

std::string ParameterSpec::full_name() const { return std::string(section) + "." + std::string(name); }

std::span<const ParameterSpec> parameter_table() {
  static const std::vector<ParameterSpec> table = make_table();
  return table;
}

}  // namespace rouleau
