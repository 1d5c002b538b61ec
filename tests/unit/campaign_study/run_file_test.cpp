// SPDX-License-Identifier: BSD-3-Clause
// Run files, and the files they name.
#include "study/run_file.hpp"

#include <gmock/gmock.h>

#include "study/error.hpp"
#include "study/whole_file.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::TemporaryDirectory;
using ::testing::HasSubstr;

TEST(CampaignRunFile, GathersSectionsAndKnowsTheStudysLines) {
  const Combination combination{{{"fluid.lambda", "5", 3}, {"cell.2.shape", "sphere", 7}, {"fluid.density", "1", 9}}};
  const RunFile run_file = run_file_of(combination, {}, FileNames::stored, "title");
  EXPECT_EQ(run_file.text, "# title\n\n[fluid]\nlambda = 5\ndensity = 1\n\n[cell.2]\nshape = sphere\n");
  EXPECT_EQ(to_study_lines("run.ini:4: bad", run_file, "study.ini"), "study.ini:3: bad");
  EXPECT_EQ(to_study_lines("run.ini:5: bad", run_file, "study.ini"), "study.ini:9: bad");
  EXPECT_EQ(to_study_lines("/tmp/x y/run.ini:8: bad", run_file, "study.ini"), "/tmp/x study.ini:7: bad");
}

TEST(CampaignRunFile, MessageWithoutLineNamesTheStudy) {
  const RunFile run_file = run_file_of({{{"a.b", "1", 3}}}, {}, FileNames::stored, "t");
  EXPECT_EQ(to_study_lines("run.ini: time.end_time_s is missing.", run_file, "study.ini"),
            "study.ini: time.end_time_s is missing.");
  EXPECT_EQ(to_study_lines("run.ini:1: title", run_file, "study.ini"), "study.ini: title");
  EXPECT_EQ(to_study_lines("run.ini:99: far", run_file, "study.ini"), "study.ini: far");
}

class StudyWithMesh : public ::testing::Test {
 protected:
  StudyWithMesh() {
    std::filesystem::create_directory(directory_.path() / "meshes");
    write_whole_file(directory_.path() / "meshes" / "cell.off", "OFF one");
    write_whole_file(directory_.path() / "meshes" / "other.off", "OFF two");
  }
  Study study_of(const std::string& rest) const {
    return parse_study("[study]\nname = s\n" + rest, directory_.path() / "study.ini");
  }
  TemporaryDirectory directory_;
};

TEST_F(StudyWithMesh, CandidateNamesTheFileByItsPlaceAndThePointByItsCopy) {
  const Study study = study_of("[cell]\nmesh_file = meshes/cell.off\n");
  const NamedFiles files = find_named_files(study);
  const NamedFile& file = files.at("meshes/cell.off");
  EXPECT_EQ(file.stored, "files/cell-" + digest_of("OFF one").substr(0, 8) + ".off");
  const Combination combination = combination_of(study, 0);
  EXPECT_THAT(run_file_of(combination, files, FileNames::source, "t").text,
              HasSubstr("mesh_file = " + (directory_.path() / "meshes/cell.off").string() + "\n"));
  EXPECT_THAT(run_file_of(combination, files, FileNames::stored, "t").text,
              HasSubstr("mesh_file = ../../" + file.stored + "\n"));
}

TEST_F(StudyWithMesh, KeptStudyNamesItsOwnCopies) {
  const Study study = study_of(
      "[cell]\nmesh_file = meshes/cell.off # a mesh\n[sweep]\ncell.reference_file = meshes/cell.off, "
      "meshes/other.off\n");
  const NamedFiles files = find_named_files(study);
  const std::string kept = with_stored_files(study, files);
  EXPECT_THAT(kept, HasSubstr("mesh_file = " + files.at("meshes/cell.off").stored + "\n"));
  EXPECT_THAT(kept, HasSubstr("cell.reference_file = " + files.at("meshes/cell.off").stored + ", " +
                              files.at("meshes/other.off").stored + "\n"));
}

TEST_F(StudyWithMesh, CopyReadAgainKeepsItsName) {
  const Study study = study_of("[cell]\nmesh_file = meshes/cell.off\n");
  const NamedFiles files = find_named_files(study);
  const std::string stored = files.at("meshes/cell.off").stored;
  std::filesystem::create_directory(directory_.path() / "files");
  write_whole_file(directory_.path() / stored, "OFF one");
  const Study again = parse_study(with_stored_files(study, files), directory_.path() / "study.ini");
  EXPECT_EQ(find_named_files(again).at(stored).stored, stored);
}

TEST_F(StudyWithMesh, StudyWithoutFilesIsKeptByteForByte) {
  const Study study = study_of("[fluid]\n  lambda=5   # five");
  EXPECT_EQ(with_stored_files(study, {}), study.text);
}

}  // namespace
}  // namespace rouleau::campaign
