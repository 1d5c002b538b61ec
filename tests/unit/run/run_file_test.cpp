// SPDX-License-Identifier: BSD-3-Clause
// Reading run files that are right; the wrong ones have their table in tests/contract/bad_run_files.
#include "run/run_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "run/identity.hpp"
#include "unit/run/run_text.hpp"

namespace rouleau {
namespace {

using test::Read;
using test::RunText;
using testing::HasSubstr;

std::string with_line_ends(std::string text, const std::string& end) {
  std::string result;
  for (const char c : text) result += c == '\n' ? end : std::string(1, c);
  return result;
}

class RunFileOnDisk : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "run_file_test_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
  }
  std::filesystem::path folder_;
};

TEST(RunFile, FillsParametersWithValuesAndDefaults) {
  const RunParameters p = Read(RunText{.fluid = "lambda = 2.5",
                                       .cell = "offset_z_um = -1/4\nrotation_axis = \"1 0 0\"",
                                       .numerics = "kernel = 2-point\nprecision = double"})
                              .run.parameters;
  EXPECT_EQ(p.fluid.lambda, 2.5);
  EXPECT_EQ(p.fluid.plasma_viscosity_mPa_s, 1.2);
  EXPECT_EQ(p.flow.driving, Driving::mean_velocity);
  ASSERT_EQ(p.cells.size(), 1u);
  EXPECT_EQ(p.cells[0].offset_z_um, -0.25);
  EXPECT_EQ(p.cells[0].rotation_axis, Vec3(1, 0, 0));
  EXPECT_EQ(p.cells[0].position_x_um, 0.5 * 128 / 3.0);
  EXPECT_EQ(p.numerics.kernel, KernelWidth::two_point);
  EXPECT_EQ(p.numerics.precision, Precision::double_);
  EXPECT_EQ(p.numerics.magic_lambda, 3.0 / 16);
  EXPECT_EQ(p.numerics.correction_interval, 500);
  EXPECT_EQ(p.output.checkpoints_kept, 3);
  EXPECT_EQ(p.bounds.max_mach, 0.1);
}

TEST(RunFile, ReadsByteOrderMarkCommentsAndForeignLineEnds) {
  const std::string text = RunText{.fluid = "lambda = 3 # a comment with = and [brackets]"}.text();
  const std::string identity = parse_run_file(text, "run.ini").identity;
  EXPECT_EQ(parse_run_file("\xEF\xBB\xBF" + text, "run.ini").identity, identity);
  EXPECT_EQ(parse_run_file(with_line_ends(text, "\r\n"), "run.ini").identity, identity);
  EXPECT_EQ(parse_run_file(text.substr(0, text.size() - 1), "run.ini").identity, identity);  // no newline at the end
}

TEST(RunFile, KnowsTheLineOfWhatWasGiven) {
  const RunFile run = Read(RunText{.fluid = "lambda = 3"}).run;
  EXPECT_EQ(run.where("fluid.lambda"), "run.ini:2");
  EXPECT_EQ(run.where("fluid.density_kg_per_m3"), "run.ini");
  EXPECT_TRUE(run.value("fluid.lambda").given);
  EXPECT_FALSE(run.value("fluid.density_kg_per_m3").given);
}

TEST(RunFile, HoldsSeveralCells) {
  const RunFile run = Read(RunText{.cell = "position_x_um = 10",
                                   .more = "[cell.3]\nshape = sphere\nradius_um = 3\nposition_x_um = 35\n"
                                           "[cell.2]\nshape = red_blood_cell\nposition_x_um = 22"})
                          .run;
  ASSERT_EQ(run.parameters.cells.size(), 3u);
  EXPECT_EQ(run.parameters.cells[1].position_x_um, 22);
  EXPECT_EQ(run.parameters.cells[2].shape, Shape::sphere);
  EXPECT_EQ(run.value("cell.3.radius_um").value, "3");
  EXPECT_EQ(run.value("cell.2.radius_um").value, "4");
}

TEST(RunFile, TakesTheFrequencyOrTheSubdivisionsOfTheMesh) {
  const auto frequency = [](const std::string& cell) {
    return Read(RunText{.cell = cell}).run.parameters.cells[0].frequency;
  };
  EXPECT_EQ(frequency(""), 16);
  EXPECT_EQ(frequency("subdivisions = 3"), 8);
  EXPECT_EQ(frequency("frequency = 12"), 12);
  EXPECT_EQ(Read(RunText{.cell = "subdivisions = 3"}).run.value("cell.frequency").value, "8");
}

TEST(RunFile, HasNoCellsWithoutAShape) {
  EXPECT_TRUE(Read(RunText{.cell = "shape = none"}).run.parameters.cells.empty());
}

TEST_F(RunFileOnDisk, FindsFilesBesideItself) {
  write("cell.off", "OFF");
  write("run.ini", RunText{.cell = "shape = mesh\nmesh_file = cell.off"}.text());
  const RunFile run = read_run_file(folder_ / "run.ini");
  EXPECT_EQ(run.parameters.cells[0].mesh_file, folder_ / "cell.off");
  EXPECT_EQ(run.value("cell.mesh_file").value, "cell.off");
}

TEST_F(RunFileOnDisk, EntersTheIdentityByTheContentOfItsMeshes) {
  write("a.off", "OFF one");
  write("b.off", "OFF one");
  write("c.off", "OFF two");
  const auto identity = [&](const std::string& mesh) {
    return parse_run_file(RunText{.cell = "shape = mesh\nmesh_file = " + mesh}.text(), folder_ / "run.ini").identity;
  };
  EXPECT_EQ(identity("a.off"), identity("b.off"));
  EXPECT_NE(identity("a.off"), identity("c.off"));
}

TEST_F(RunFileOnDisk, OfMoreThanOneMebibyteIsRefused) {
  write("run.ini", RunText{}.text() + std::string(1 << 20, '\n'));
  try {
    read_run_file(folder_ / "run.ini");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), Exit::bad_input);
    EXPECT_THAT(e.what(), HasSubstr("1048576 bytes"));
  }
}

TEST_F(RunFileOnDisk, ThatIsThereButCannotBeOpenedIsAnIoFailure) {
  write("cell.off", "OFF");
  const std::string text = RunText{.cell = "shape = mesh\nmesh_file = cell.off"}.text();
  write("run.ini", text);
  const auto failure = [](const auto& work) {
    rlimit limit{};
    getrlimit(RLIMIT_NOFILE, &limit);
    const rlimit none{0, limit.rlim_max};
    setrlimit(RLIMIT_NOFILE, &none);
    Exit code = Exit::finished;
    try {
      work();
    } catch (const Error& e) {
      code = e.code();
    }
    setrlimit(RLIMIT_NOFILE, &limit);
    return code;
  };
  EXPECT_EQ(failure([&] { read_run_file(folder_ / "run.ini"); }), Exit::io) << "it may pass";
  EXPECT_EQ(failure([&] { parse_run_file(text, folder_ / "run.ini"); }), Exit::io) << "of a mesh too";
}

TEST_F(RunFileOnDisk, ThatIsMissingOrAFolderIsRefused) {
  for (const auto& path : {folder_ / "missing.ini", folder_}) {
    try {
      read_run_file(path);
      FAIL();
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), Exit::bad_input);
      EXPECT_THAT(e.what(), HasSubstr("cannot be read"));
    }
  }
}

std::string identity_of(const RunText& text) { return Read(text).run.identity; }

TEST(Identity, IgnoresDefaultsThatAreNamedAndHowNumbersAreWritten) {
  const std::string plain = identity_of({.fluid = "lambda = 4.75"});
  EXPECT_EQ(plain.size(), 32u);
  EXPECT_EQ(plain, identity_of({.fluid = "lambda = 4.750"}));
  EXPECT_EQ(plain,
            identity_of({.fluid = "lambda = 19/4\ndensity_kg_per_m3 = 1000", .numerics = "magic_lambda = 0.1875"}));
  EXPECT_EQ(plain, identity_of({.fluid = "lambda = 4.75", .cell = "position_x_um = 64/3"}));  // half of the length
  EXPECT_EQ(plain, identity_of({.fluid = "lambda = 4.75", .cell = "frequency = 16"}));        // 4 subdivisions
}

TEST(Identity, IgnoresFreeParameters) {
  EXPECT_EQ(identity_of({}),
            identity_of({.time = "end_time_s = 1", .output = "checkpoints_kept = 5", .bounds = "max_mach = 0.05"}));
}

TEST(Identity, ChangesWithEachIdentityParameter) {
  const std::vector<RunText> others{{.fluid = "lambda = 4"},
                                    {.flow = "mean_velocity_mm_per_s = 1.4"},
                                    {.cell = "replica = 1\njitter_um = 0.1"},
                                    {.cell = "replica = 2\njitter_um = 0.1"},
                                    {.membrane = "shear_modulus_convention = G_s"},
                                    {.numerics = "precision = double"},
                                    {.more = "[cell.2]\nshape = red_blood_cell"}};
  std::vector<std::string> identities{identity_of({})};
  for (const auto& other : others) {
    const std::string identity = parse_run_file(other.text(), "run.ini").identity;
    EXPECT_THAT(identities, testing::Not(testing::Contains(identity)));
    identities.push_back(identity);
  }
}

TEST(Identity, IsTheDigestThatTheContractDescribes) {
  const ParameterValue changed{"b.x", "2", "1", "2", ParameterKind::identity, true, 3};
  const ParameterValue file{"a.file", "mesh.off", "", "xxh3:00", ParameterKind::identity, true, 4};
  const ParameterValue at_default{"c.y", "7", "7", "7", ParameterKind::identity, true, 5};
  const ParameterValue free{"d.z", "8", "9", "8", ParameterKind::free, true, 6};
  // `printf 'a.file=xxh3:00\nb.x=2\n' | xxh128sum`
  EXPECT_EQ(identity_digest({changed, file, at_default, free}), "9d607a1136c317819243311add3f7ad0");
  EXPECT_EQ(identity_digest({file, changed}), identity_digest({changed, file}));
}

}  // namespace
}  // namespace rouleau
