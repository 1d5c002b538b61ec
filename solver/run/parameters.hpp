// SPDX-License-Identifier: BSD-3-Clause
// What a run file says, typed, in the user's units (which the names carry); the table behind it is parameter_table.hpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/vec3.hpp"
#include "coupling/advect.hpp"
#include "membrane/cells.hpp"
#include "membrane/moduli_conventions.hpp"

namespace rouleau {

// The order of the enumerators is the order of the choices in the parameter table.
enum class Boundary { wall, periodic };
enum class Driving { mean_velocity, pressure_gradient, shear, rest };
enum class InitialFlow { rest, developed, uniform };
enum class Shape { red_blood_cell, sphere, ellipsoid, mesh, checkpoint, none };
enum class OffsetFrom { axis, checkpoint };
enum class Reference { initial, file };
enum class StretchAxis { none, x, y, z };
enum class Precision { single_, double_ };
enum class CollisionLaw { trt, mrt };
enum class KernelWidth { two_point, three_point, four_point };
enum class UnsafeCombination { refuse, run };
enum class TrackingChoice { vertex_normals, vertex_normals_wide, face_normals, off };

struct FluidParameters {
  double lambda = 0;  ///< viscosity inside / viscosity outside
  double plasma_viscosity_mPa_s = 0;
  double density_kg_per_m3 = 0;
};

struct ChannelParameters {
  double length_x_um = 0, length_y_um = 0, length_z_um = 0;
  Boundary boundary_y{}, boundary_z{};  ///< x is always periodic
};

struct FlowParameters {
  Driving driving{};
  double mean_velocity_mm_per_s = 0;      ///< 0 unless driving = mean_velocity
  double pressure_gradient_Pa_per_m = 0;  ///< -dp/dx; 0 unless driving = pressure_gradient
  double shear_rate_per_s = 0;            ///< 0 unless driving = shear
  InitialFlow initial{};
  double initial_velocity_mm_per_s = 0;  ///< 0 unless initial = uniform
};

struct CellParameters {
  Shape shape{};
  double radius_um = 0;
  Vec3 semi_axes_um = Vec3::Zero();
  int subdivisions = 0;
  int frequency = 0;                ///< of the divided icosahedron: as given, or 2^subdivisions
  std::filesystem::path mesh_file;  ///< resolved against the run file's folder; empty unless shape = mesh | checkpoint
  int mesh_cell = 0;
  OffsetFrom offset_from{};
  double scale = 0;
  double offset_y_um = 0, offset_z_um = 0;  ///< of the centre from the channel axis
  double position_x_um = 0;                 ///< of the centre from the periodic seam
  Vec3 rotation_axis = Vec3::Zero();        ///< as given, not normalised
  double rotation_angle_deg = 0;
  Reference reference{};
  std::filesystem::path reference_file;  ///< resolved; empty unless reference = file
  double jitter_um = 0;
  std::int64_t replica = 0;
};

struct MembraneParameters {
  InPlaneLaw law{};
  double shear_modulus_uN_per_m = 0;  ///< in shear_modulus_convention
  ShearConvention shear_modulus_convention{};
  double area_ratio = 0;  ///< C = kappa_A / kappa_S; means nothing to the neo-Hookean law
  double bending_modulus_J = 0;
};

/// Opposite forces on the two ends of each cell, as of optical tweezers.
struct StretchParameters {
  StretchAxis axis{};
  double force_pN = 0;  ///< on each end; 0 unless there is an axis, like those below
  double share = 0;     ///< of the vertices, at each end
  double ramp_ms = 0;   ///< until the force is whole
};

struct NumericsParameters {
  double node_spacing_um = 0;
  double time_step_us = 0;
  double tau_plasma = 0;
  Precision precision{};
  CollisionLaw collision{};
  double magic_lambda = 0;
  double omega_e = 0, omega_eps = 0, omega_q = 0, omega_pi = 0, omega_m = 0;
  KernelWidth kernel{};
  Advection advection{};
  TrackingChoice tracking{};
  double mesh_mobility = 0;              ///< share of the response hidden by the kernel
  double fold_resistance = 0;            ///< of edges sharper than 60 degrees, in kappa_B
  std::int64_t correction_interval = 0;  ///< steps; 0 = never
};

struct TimeParameters {
  double end_time_s = 0;
};

struct OutputParameters {
  std::int64_t sample_interval_steps = 0;
  double progress_interval_s = 0;      ///< wall clock
  double checkpoint_interval_min = 0;  ///< wall clock
  int checkpoints_kept = 0;
  double snapshot_interval_s = 0;       ///< physical time; of fields and cells; 0: none
  double cell_snapshot_interval_s = 0;  ///< physical time; of cells alone; 0: none
  int snapshot_stride = 1;              ///< every n-th node of the fields
};

struct BoundsParameters {
  UnsafeCombination unsafe_combination{};
  double area_ratio_min = 0, area_ratio_max = 0;
  double inside_ratio_min = 0, inside_ratio_max = 0;
  double max_mach = 0;
};

struct RunParameters {
  FluidParameters fluid;
  ChannelParameters channel;
  FlowParameters flow;
  std::vector<CellParameters> cells;  ///< empty when [cell] shape = none
  MembraneParameters membrane;
  StretchParameters stretch;
  NumericsParameters numerics;
  TimeParameters time;
  OutputParameters output;
  BoundsParameters bounds;
};

}  // namespace rouleau
