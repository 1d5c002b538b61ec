// SPDX-License-Identifier: BSD-3-Clause
#include "contract/bad_run_files/bad_run_files.hpp"

namespace rouleau::test {

std::vector<std::string> good_run_file() {
  return {
      "[fluid]",                       //  1
      "lambda = 5",                    //  2
      "[channel]",                     //  3
      "length_x_um = 21",              //  4
      "length_y_um = 12",              //  5
      "length_z_um = 10",              //  6
      "[flow]",                        //  7
      "driving = mean_velocity",       //  8
      "mean_velocity_mm_per_s = 1.5",  //  9
      "[cell]",                        // 10
      "shape = red_blood_cell",        // 11
      "subdivisions = 3",              // 12
      "[membrane]",                    // 13
      "area_ratio = 100",              // 14
      "[numerics]",                    // 15
      "node_spacing_um = 1/2",         // 16
      "time_step_us = 25/36",          // 17
      "tau_plasma = 1.5",              // 18
      "[time]",                        // 19
      "end_time_s = 0.0001",           // 20
      "[output]",                      // 21
      "sample_interval_steps = 100",   // 22
  };
}

std::string text_of(const BadRunFile& bad) {
  std::vector<std::string> lines = good_run_file();
  for (const auto& edit : bad.edits) lines.at(static_cast<std::size_t>(edit.line - 1)) = edit.text;
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

namespace {

std::string many_cells() {
  std::string text = "sample_interval_steps = 100";
  for (int cell = 2; cell <= 1002; ++cell) text += "\n[cell." + std::to_string(cell) + "]";
  return text;
}

std::vector<BadRunFile> wrong_text() {
  return {
      {"UnknownParameter", {{2, "lamda = 5"}}, 2, {"unknown parameter lamda", "did you mean lambda"}},
      {"UnknownParameterWithoutUnit", {{20, "end_time = 1"}}, 20, {"unknown parameter end_time", "end_time_s"}},
      {"UnknownParameterUnlikeAny", {{22, "colour = red"}}, 22, {"unknown parameter colour", "--help-run-file"}},
      {"ParameterInTheWrongSection", {{22, "lambda = 5"}}, 22, {"unknown parameter lambda", "[fluid]"}},
      {"UnknownSection", {{3, "[chanel]"}}, 3, {"unknown section [chanel]", "[channel]"}},
      {"SectionUnlikeAny", {{21, "[quantum]"}}, 21, {"unknown section [quantum]", "membrane"}},
      {"DuplicateParameter", {{18, "tau_plasma = 1.5\ntau_plasma = 1"}}, 19, {"tau_plasma", "line 18"}},
      {"DuplicateSection", {{21, "[fluid]"}}, 21, {"[fluid]", "line 1"}},
      {"EntryBeforeAnySection", {{1, "lambda = 4\n[fluid]"}}, 1, {"before the first [section]"}},
      {"LineWithoutEquals", {{2, "lambda 5"}}, 2, {"`lambda 5`", "name = value"}},
      {"NameMissing", {{2, "= 5"}}, 2, {"`= 5`", "name = value"}},
      {"ValueMissing", {{2, "lambda ="}}, 2, {"lambda has no value"}},
      {"ValueCommentedAway", {{2, "lambda = # 5"}}, 2, {"lambda has no value"}},
      {"SectionNotClosed", {{3, "[channel"}}, 3, {"`[channel`", "[name]"}},
      {"SectionWithoutName", {{3, "[ ]"}}, 3, {"needs a name"}},
      {"ControlCharacter", {{2, std::string("lambda = 5\x01")}}, 2, {"byte 0x01", "column 11"}},
      {"NotUtf8", {{2, "lambda = 5 # \xb5"}}, 2, {"byte 0xb5", "UTF-8"}},
      {"TooManyCells", {{22, many_cells()}}, 1022, {"[cell.1001]", "at most 1000 cells"}},
      {"EndlessLine", {{2, "lambda = " + std::string(2000, '1')}}, 2, {"2009 bytes", "at most 1000"}},
  };
}

std::vector<BadRunFile> wrong_values() {
  return {
      {"WordForNumber", {{2, "lambda = five"}}, 2, {"lambda = five", "is not a number"}},
      {"NumberWithUnit", {{4, "length_x_um = 21 um"}}, 4, {"21 um", "is not a number"}},
      {"DecimalComma", {{9, "mean_velocity_mm_per_s = 1,5"}}, 9, {"1,5", "decimal point"}},
      {"NotANumber", {{2, "lambda = nan"}}, 2, {"lambda = nan", "not finite"}},
      {"Infinite", {{20, "end_time_s = inf"}}, 20, {"inf", "not finite"}},
      {"TooLargeForDouble", {{20, "end_time_s = 1e999"}}, 20, {"1e999", "too large"}},
      {"DivisionByZero", {{16, "node_spacing_um = 1/0"}}, 16, {"1/0", "divides by zero"}},
      {"TwoFractions", {{16, "node_spacing_um = 1/2/3"}}, 16, {"1/2/3", "is not a number"}},
      {"FractionForInteger", {{22, "sample_interval_steps = 1/2"}}, 22, {"1/2", "whole number"}},
      {"RealForInteger", {{12, "subdivisions = 3.0"}}, 12, {"3.0", "whole number"}},
      {"IntegerTooLarge", {{22, "sample_interval_steps = 99999999999999999999"}}, 22, {"too large"}},
      {"LambdaBelowRange", {{2, "lambda = 0.05"}}, 2, {"lambda = 0.05", "0.1 to 100"}},
      {"LambdaAboveRange", {{2, "lambda = 101"}}, 2, {"lambda = 101", "0.1 to 100"}},
      {"NegativeLength", {{5, "length_y_um = -12"}}, 5, {"length_y_um = -12", "outside its range"}},
      {"SubdivisionsAboveRange", {{12, "subdivisions = 6"}}, 12, {"2 to 5"}},
      {"FrequencyAboveRange", {{12, "frequency = 33"}}, 12, {"4 to 32"}},
      {"MeshGivenTwice",
       {{12, "subdivisions = 3\nfrequency = 8"}},
       13,
       {"frequency = 8", "subdivisions = 3 (line 12)", "remove one"}},
      {"SampleIntervalZero", {{22, "sample_interval_steps = 0"}}, 22, {"sample_interval_steps = 0", "1 to 1e+12"}},
      {"OneCheckpointKept", {{22, "checkpoints_kept = 1"}}, 22, {"2 to 1000"}},
      {"TauBelowRange", {{18, "tau_plasma = 0.5"}}, 18, {"tau_plasma = 0.5", "0.51 to"}},
      {"UnknownChoice",
       {{8, "driving = mean_velocty"}},
       8,
       {"none of mean_velocity, pressure_gradient", "did you mean"}},
      {"ChoiceInWrongCase", {{11, "shape = Sphere"}}, 11, {"shape = Sphere", "did you mean sphere"}},
      {"TwoComponents", {{12, "rotation_axis = 0 1"}}, 12, {"rotation_axis = 0 1", "three numbers"}},
      {"FourComponents", {{12, "rotation_axis = 0 1 0 0"}}, 12, {"three numbers"}},
      {"AxisWithoutDirection", {{12, "rotation_axis = 0 0 0"}}, 12, {"no direction"}},
      {"MissingMeshFile", {{11, "shape = mesh"}, {12, "mesh_file = nowhere.off"}}, 12, {"nowhere.off", "No such file"}},
      {"MeshFileWithoutEnd", {{11, "shape = mesh"}, {12, "mesh_file = /dev/zero"}}, 12, {"is not a regular file"}},
      {"MeshFileIsAFolder", {{11, "shape = mesh"}, {12, "mesh_file = ."}}, 12, {"is a directory"}},
  };
}

std::vector<BadRunFile> missing_or_unused() {
  return {
      {"LengthMissing", {{4, ""}}, 3, {"length_x_um is missing in [channel]"}},
      {"EndTimeMissing", {{20, ""}}, 19, {"end_time_s is missing"}},
      {"WholeSectionMissing", {{19, ""}, {20, ""}}, 22, {"end_time_s is missing in [time]"}},
      {"VelocityMissing", {{9, ""}}, 8, {"mean_velocity_mm_per_s is missing", "driving = mean_velocity needs it"}},
      {"GradientMissing", {{8, "driving = pressure_gradient"}, {9, ""}}, 8, {"pressure_gradient_Pa_per_m is missing"}},
      {"SemiAxesMissing", {{11, "shape = ellipsoid"}}, 11, {"semi_axes_um is missing", "shape = ellipsoid needs it"}},
      {"MeshFileNotNamed", {{11, "shape = mesh"}, {12, ""}}, 11, {"mesh_file is missing"}},
      {"ReferenceFileMissing", {{12, "reference = file"}}, 12, {"reference_file is missing"}},
      {"SpeedOfPlugFlowMissing",
       {{9, "mean_velocity_mm_per_s = 1\ninitial = uniform"}},
       10,
       {"initial_velocity_mm_per_s is missing"}},
      {"VelocityWithPressureDriving",
       {{8, "driving = pressure_gradient"}},
       9,
       {"mean_velocity_mm_per_s means nothing with driving = pressure_gradient"}},
      {"RadiusOfAnEllipsoid",
       {{11, "shape = ellipsoid"}, {12, "semi_axes_um = 4 4 2\nradius_um = 4"}},
       13,
       {"radius_um means nothing with shape = ellipsoid", "red_blood_cell or sphere"}},
      {"AreaRatioOfANeoHookeanMembrane",
       {{14, "law = neo_hookean\narea_ratio = 100"}},
       15,
       {"area_ratio means nothing with law = neo_hookean"}},
      {"ForceWithoutAStretchAxis",
       {{13, "[stretch]\nforce_pN = 10\n[membrane]"}},
       14,
       {"force_pN means nothing with axis = none", "axis = x or y or z"}},
      {"StretchWithoutAForce", {{13, "[stretch]\naxis = x\n[membrane]"}}, 14, {"force_pN is missing in [stretch]"}},
      {"MrtRateWithTrt", {{18, "omega_q = 1.2"}}, 18, {"omega_q means nothing with collision = trt"}},
      {"MagicNumberWithMrt", {{18, "collision = mrt\nmagic_lambda = 1/4"}}, 19, {"magic_lambda means nothing"}},
      {"CorrectionWithoutTracking",
       {{2, "lambda = 1"}, {18, "tracking = off\ncorrection_interval = 100"}},
       19,
       {"correction_interval means nothing with tracking = off"}},
      {"LambdaWithoutCell", {{11, "shape = none"}, {12, ""}}, 2, {"lambda means nothing with cell.shape = none"}},
      {"MembraneWithoutCell", {{2, ""}, {11, "shape = none"}, {12, ""}}, 14, {"area_ratio means nothing"}},
      {"SecondCellWithoutShape", {{12, "[cell.2]"}}, 12, {"shape is missing in [cell.2]"}},
      {"SecondCellOfNone", {{12, "[cell.2]\nshape = none"}}, 13, {"shape = none in [cell.2]"}},
      {"CellNumbersWithAGap", {{12, "[cell.3]\nshape = sphere"}}, 12, {"[cell.3]", "[cell.2]"}},
      {"FirstCellNumbered", {{10, "[cell.1]"}}, 10, {"[cell.1]", "the first is [cell]"}},
      {"CellNumberIsAWord", {{10, "[cell.two]"}}, 10, {"[cell.two]"}},
      {"ReplicaWithoutJitter", {{12, "replica = 2"}}, 12, {"replica = 2", "jitter_um"}},
  };
}

std::vector<BadRunFile> cannot_work() {
  return {
      {"LengthNotAMultiple",
       {{4, "length_x_um = 21.3"}},
       4,
       {"42.6 node spacings", "21 (42 nodes)", "21.5 (43 nodes)"}},
      {"LatticeTooThin", {{6, "length_z_um = 1"}}, 6, {"2 node spacings", "at least 4"}},
      {"LatticeTooLong",
       {{4, "length_x_um = 1e5"}, {16, "node_spacing_um = 1e-3"}, {17, "time_step_us = 1e-6"}},
       16,
       {"at most 1e9"}},
      {"TooFewNodesPerRadius", {{16, "node_spacing_um = 1"}}, 16, {"4 nodes per radius", "at least 6", "0.6667"}},
      {"MachTooHigh", {{9, "mean_velocity_mm_per_s = 200"}}, 17, {"Mach number 1", "max_mach = 0.1", "time_step_us"}},
      {"InsideTauTooHigh", {{2, "lambda = 60"}}, 2, {"tau = 60.5", "at most 50"}},
      {"InsideTauTooLow", {{2, "lambda = 0.1"}, {18, "tau_plasma = 0.52"}}, 2, {"tau = 0.502", "0.505"}},
      {"MembraneTooStiff", {{14, "area_ratio = 1000"}}, 17, {"kappa_A dt/(mu dx) = 5.79", "above 2.5", "0.3 or less"}},
      {"BendingTooStiff", {{14, "bending_modulus_J = 1e-16"}}, 17, {"kappa_B dt/(mu dx^3) = 0.463", "0.26"}},
      {"CellInTheWall", {{12, "offset_z_um = 4"}}, 12, {"cell 0", "z wall"}},
      {"CellWiderThanChannel", {{12, "radius_um = 7"}}, 5, {"length_y_um = 12 is too short", "14 um"}},
      {"CellLongerThanThePeriod", {{4, "length_x_um = 9"}}, 4, {"length_x_um = 9 is too short", "image"}},
      {"CellBeyondTheLength", {{12, "position_x_um = 22"}}, 12, {"position_x_um = 22", "21 um"}},
      {"FrozenInside", {{18, "tracking = off"}}, 18, {"tracking = off", "lambda = 5"}},
      {"DrivenBoxWithoutWalls",
       {{6, "length_z_um = 10\nboundary_y = periodic\nboundary_z = periodic"}},
       10,
       {"accelerates a box without walls"}},
      {"ShearWithoutWalls",
       {{6, "length_z_um = 10\nboundary_z = periodic"}, {8, "driving = shear"}, {9, "shear_rate_per_s = 9"}},
       9,
       {"boundary_z = wall"}},
      {"PlugFlowBetweenWalls",
       {{8, "driving = rest"}, {9, "initial = uniform\ninitial_velocity_mm_per_s = 1"}},
       9,
       {"plug flow, which walls forbid"}},
      {"DevelopedRest", {{8, "driving = rest"}, {9, "initial = developed"}}, 9, {"needs a driving"}},
      {"DevelopedShearBetweenSideWalls",
       {{8, "driving = shear\nshear_rate_per_s = 9"}, {9, "initial = developed"}},
       10,
       {"boundary_y = periodic"}},
      {"EndBeforeTheFirstStep", {{20, "end_time_s = 1e-9"}, {17, "time_step_us = 1e4"}}, 20, {"1e-07 steps"}},
      {"TooManySteps", {{20, "end_time_s = 1e6"}, {17, "time_step_us = 1e-6"}}, 20, {"1e+18 steps", "1e+15"}},
      {"MeshTooCoarse", {{12, "subdivisions = 2"}}, 12, {"edges up to", "above 2"}, true},
  };
}

}  // namespace

std::vector<BadRunFile> bad_run_files() {
  std::vector<BadRunFile> all;
  for (auto* part : {wrong_text, wrong_values, missing_or_unused, cannot_work}) {
    const auto cases = part();
    all.insert(all.end(), cases.begin(), cases.end());
  }
  return all;
}

}  // namespace rouleau::test
