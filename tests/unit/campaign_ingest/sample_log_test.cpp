// SPDX-License-Identifier: BSD-3-Clause
// Reading a log in parts, cut back, torn and damaged.
#include "ingest/sample_log.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "written_campaign.hpp"

namespace rouleau::campaign {
namespace {

using ::rouleau::testing::content_of;
using ::rouleau::testing::set_content;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::log_header;
using testing::log_line;
using testing::log_lines;

class SampleLogTest : public ::testing::Test {
 protected:
  [[nodiscard]] LogPart read(const SampleMark& mark = {}) const { return read_sample_log(file_, mark); }

  ::rouleau::testing::TemporaryDirectory directory_;
  std::filesystem::path file_ = directory_.path() / "samples.csv";
};

TEST_F(SampleLogTest, AllColumnsAreRead) {
  set_content(file_, log_header + log_line(100, "0.81", 2));
  const LogPart part = read();
  ASSERT_EQ(part.rows.size(), 1U);
  const SampleRow& row = part.rows[0];
  EXPECT_EQ(row.step, 100);
  EXPECT_EQ(row.cell, 2);
  EXPECT_EQ(row.time_s, 0.001);
  EXPECT_EQ(row.d_um, 0.81);
  EXPECT_EQ(row.asphericity, 0.15);
  EXPECT_EQ(row.inclination_deg, -12.5);
  EXPECT_EQ(row.inside_nodes, 801);
  EXPECT_EQ(row.flips, 3);
  EXPECT_EQ(row.velocity_x_mm_per_s, 2.1);
  EXPECT_TRUE(row.finite);
  EXPECT_THAT(part.warnings, IsEmpty());
}

TEST_F(SampleLogTest, ShapeAndMarkersAreReadWhereTheyAreAndUnsetWhereNot) {
  const std::string line = "7,0.001,0,0.3,0.1,0.25,31.5,-2,8,7.5,4,0.1,4,0.2,-1,0.3,1.5";
  set_content(file_,
              "step,time_s,cell,d_um,asphericity,taylor_deformation,angle_xz_deg,angle_xy_deg,extent_x_um,extent_y_um,"
              "extent_z_um,marker_y_dx_um,marker_y_dy_um,marker_y_dz_um,marker_z_dx_um,marker_z_dy_um,marker_z_dz_um,"
              "check\n" +
                  line + "," + digest_of(line) + "\n");
  const LogPart part = read();
  ASSERT_EQ(part.rows.size(), 1U);
  const SampleRow& row = part.rows[0];
  EXPECT_EQ(row.taylor_deformation, 0.25);
  EXPECT_EQ(row.angle_xz_deg, 31.5);
  EXPECT_EQ(row.angle_xy_deg, -2);
  EXPECT_EQ(row.extent_x_um, 8);
  EXPECT_EQ(row.extent_z_um, 4);
  EXPECT_EQ(row.marker_y_dy_um, 4);
  EXPECT_EQ(row.marker_z_dx_um, -1);
  EXPECT_EQ(row.marker_z_dz_um, 1.5);
  EXPECT_TRUE(row.finite);

  set_content(file_, log_header + log_line(100, "0.81"));  // of an older solver
  EXPECT_EQ(read().rows.at(0).marker_z_dx_um, std::nullopt);
  EXPECT_TRUE(read().rows.at(0).finite);
}

TEST_F(SampleLogTest, PartsTogetherAreTheWhole) {
  set_content(file_, log_header + log_lines(0, 1000));
  const LogPart first = read();
  set_content(file_, log_header + log_lines(0, 2000));
  const LogPart second = read(first.mark);
  EXPECT_TRUE(first.from_start);
  EXPECT_FALSE(second.from_start);
  std::vector<SampleRow> together = first.rows;
  together.insert(together.end(), second.rows.begin(), second.rows.end());
  EXPECT_EQ(together, read().rows);
  EXPECT_EQ(second.mark, read().mark);
  EXPECT_TRUE(read(second.mark).rows.empty());
}

TEST_F(SampleLogTest, LineBeingWrittenIsLeftForLater) {
  const std::string line = log_line(100, "0.5");
  set_content(file_, log_header + log_line(0, "0.5") + line.substr(0, 20));
  const LogPart part = read();
  EXPECT_EQ(part.rows.size(), 1U);
  EXPECT_EQ(part.unfinished_bytes, 20);
  EXPECT_THAT(part.warnings, IsEmpty());
  set_content(file_, log_header + log_line(0, "0.5") + line);
  EXPECT_EQ(read(part.mark).rows.size(), 1U);
}

TEST_F(SampleLogTest, LogThatWasCutBackIsReadAnew) {
  set_content(file_, log_header + log_lines(0, 2000));
  const SampleMark mark = read().mark;
  set_content(file_, log_header + log_lines(0, 1000));
  const LogPart part = read(mark);
  EXPECT_TRUE(part.from_start);
  EXPECT_EQ(part.rows.size(), 11U);
}

TEST_F(SampleLogTest, LogThatWasCutBackAndGrewDifferentlyIsReadAnew) {
  set_content(file_, log_header + log_lines(0, 2000));
  const SampleMark mark = read().mark;
  set_content(file_, log_header + log_lines(0, 1000) + log_line(1050, "0.5") + log_lines(1100, 3000));
  const LogPart part = read(mark);
  EXPECT_TRUE(part.from_start);
  EXPECT_EQ(part.rows.size(), 32U);
}

TEST_F(SampleLogTest, LogThatWasCutBackAndWrittenAgainIsTheSame) {
  set_content(file_, log_header + log_lines(0, 2000));
  const SampleMark mark = read().mark;
  set_content(file_, log_header + log_lines(0, 3000));
  EXPECT_FALSE(read(mark).from_start);
}

TEST_F(SampleLogTest, DamagedLineEndsTheValidPartAndIsNamed) {
  const std::string text = log_header + log_lines(0, 2000);
  std::string damaged = text;
  damaged[text.find("\n1000,") + 8] ^= 1;
  set_content(file_, damaged);
  const LogPart part = read();
  EXPECT_EQ(part.rows.size(), 10U);
  ASSERT_EQ(part.warnings.size(), 1U);
  EXPECT_THAT(part.warnings[0], HasSubstr("samples.csv: line 12 (byte "));
  EXPECT_THAT(part.warnings[0], HasSubstr("check does not match"));
  EXPECT_EQ(part.mark.offset, static_cast<std::int64_t>(text.find("\n1000,") + 1));
}

TEST_F(SampleLogTest, ZeroedTailOfACrashIsNotRead) {
  set_content(file_, log_header + log_line(0, "0.5") + std::string(300, '\0') + "\n");
  EXPECT_EQ(read().rows.size(), 1U);
  EXPECT_EQ(read().warnings.size(), 1U);
}

TEST_F(SampleLogTest, StepsThatGoBackAreDamage) {
  set_content(file_, log_header + log_line(200, "0.5") + log_line(100, "0.5"));
  EXPECT_EQ(read().rows.size(), 1U);
  EXPECT_THAT(read().warnings, ElementsAre(HasSubstr("comes behind step 200")));
}

TEST_F(SampleLogTest, RepeatedLineIsDamageBehindAMarkToo) {
  set_content(file_, log_header + log_line(100, "0.5") + log_line(200, "0.5"));
  const SampleMark mark = read().mark;
  set_content(file_, log_header + log_line(100, "0.5") + log_line(200, "0.5") + log_line(200, "0.5"));
  const LogPart part = read(mark);
  EXPECT_THAT(part.rows, IsEmpty());
  EXPECT_THAT(part.warnings, ElementsAre(HasSubstr("comes behind step 200")));
}

TEST_F(SampleLogTest, FolderAndPipeAreNoLogs) {
  std::filesystem::create_directory(file_);
  EXPECT_THAT(read().warnings, ElementsAre(HasSubstr("not a regular file")));
  std::filesystem::remove(file_);
  ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
  EXPECT_THAT(read().warnings, ElementsAre(HasSubstr("not a regular file")));
}

TEST_F(SampleLogTest, ColumnsAreFoundByNameAndUnknownOnesPassedBy) {
  const std::string line = "0.3,x,7,0.001,0,0.1";
  set_content(file_, "d_um,future,step,time_s,cell,asphericity,check\n" + line + "," + digest_of(line) + "\n");
  const LogPart part = read();
  ASSERT_EQ(part.rows.size(), 1U);
  EXPECT_EQ(part.rows[0].step, 7);
  EXPECT_EQ(part.rows[0].d_um, 0.3);
  EXPECT_EQ(part.rows[0].flips, std::nullopt);
}

TEST_F(SampleLogTest, HeaderWithoutANeededColumnIsDamage) {
  set_content(file_, "step,time_s,cell,check\n");
  EXPECT_THAT(read().warnings, ElementsAre(HasSubstr("no column `d_um`")));
}

TEST_F(SampleLogTest, ValueThatIsNotFiniteIsMarked) {
  set_content(file_, log_header + log_line(0, "nan") + log_line(100, "inf") + log_line(200, "0.5"));
  const LogPart part = read();
  ASSERT_EQ(part.rows.size(), 3U);
  EXPECT_EQ(part.rows[0].d_um, std::nullopt);
  EXPECT_FALSE(part.rows[1].finite);
  EXPECT_TRUE(part.rows[2].finite);
}

TEST_F(SampleLogTest, LogOfManyBlocksIsReadWholeAndInParts) {
  const std::string text = log_header + log_lines(0, 3'000'000);  // 3 MB
  set_content(file_, text);
  const LogPart whole = read();
  EXPECT_EQ(whole.rows.size(), 30001U);
  EXPECT_EQ(whole.mark.offset, static_cast<std::int64_t>(text.size()));
  set_content(file_, log_header + log_lines(0, 1000));
  const SampleMark mark = read().mark;
  set_content(file_, text + "31");
  const LogPart rest = read(mark);
  EXPECT_EQ(rest.rows.size(), 30001U - 11);
  EXPECT_EQ(rest.unfinished_bytes, 2);
  EXPECT_EQ(rest.mark, whole.mark);
}

TEST_F(SampleLogTest, LineWithoutEndIsDamageAndNeverHeldInMemory) {
  set_content(file_, log_header + log_line(0, "0.5"));
  std::filesystem::resize_file(file_, std::uintmax_t{1} << 30);  // a hole: all zeros
  const LogPart part = read();
  EXPECT_EQ(part.rows.size(), 1U);
  EXPECT_THAT(part.warnings, ElementsAre(HasSubstr("line 3 (byte ")));
  EXPECT_THAT(part.warnings, ElementsAre(HasSubstr("does not end within 65536 bytes")));
  set_content(file_, "");
  std::filesystem::resize_file(file_, std::uintmax_t{1} << 30);
  EXPECT_THAT(read().warnings, ElementsAre(HasSubstr("line 1 (byte 0): it does not end")));
}

TEST_F(SampleLogTest, LogThatLostItsHeaderIsNoLogThatWasCutBack) {
  set_content(file_, log_header + log_lines(0, 1000));
  const SampleMark mark = read().mark;
  set_content(file_, "");
  EXPECT_THAT(read().warnings, IsEmpty()) << "never read before: it is just being made";
  EXPECT_THAT(read(mark).warnings, ElementsAre(HasSubstr("line 1 (byte 0)")));
}

TEST_F(SampleLogTest, MissingLogIsEmptyAndVanishedOneIsSaid) {
  EXPECT_TRUE(read().rows.empty());
  EXPECT_THAT(read().warnings, IsEmpty());
  EXPECT_THAT(read({100, "x"}).warnings, ElementsAre(HasSubstr("is gone")));
}

}  // namespace
}  // namespace rouleau::campaign
