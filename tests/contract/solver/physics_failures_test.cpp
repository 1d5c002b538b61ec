// SPDX-License-Identifier: BSD-3-Clause
// Whatever way a state loses its meaning, the run ends with 70 and says when, where, how far off, what is left and what
// to try (share/contract.md section 6); on several ranks all of them do, in the words of a single one.
#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "base/error.hpp"
#include "fluid/lattice.hpp"
#include "restart/small_run.hpp"
#include "run/run_loop.hpp"

namespace rouleau::testing {
namespace {

using ::testing::HasSubstr;

/// The arrays of a run at step 0, to be spoiled.
class State {
 public:
  explicit State(Simulation& simulation) : list_(simulation.persistent()), cells_(simulation.cells()) {}

  /// Adds to population q at node (21, 15, 12), which of two ranks the second one owns, however the lattice is cut.
  void add(int q, double value) {
    Int3 n{21, 15, 12};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      n[axis] -= list_.block.begin[axis];
      if (n[axis] < 0 || n[axis] >= list_.block.size[axis]) return;
    }
    LatticeItem& f = list_.lattice_items.at(0);
    static_cast<double*>(f.data.at(static_cast<std::size_t>(q)))[f.layout.index(n[0], n[1], n[2])] += value;
  }
  [[nodiscard]] double& X(int axis, std::int32_t vertex) {
    return static_cast<double*>(list_.replicated_items.at(0).data)[static_cast<std::size_t>(axis) * cells_.vertices() +
                                                                   static_cast<std::size_t>(vertex)];
  }
  void shift(int axis, double distance) {
    for (std::int32_t v = 0; v < vertices(); ++v) X(axis, v) += distance;
  }
  void scale(double factor) {
    for (int axis = 0; axis < 3; ++axis) {
      double mean = 0;
      for (std::int32_t v = 0; v < vertices(); ++v) mean += X(axis, v) / vertices();
      for (std::int32_t v = 0; v < vertices(); ++v) X(axis, v) = mean + factor * (X(axis, v) - mean);
    }
  }
  /// Puts the first corner of the first triangle where it lies on the other side of the opposite edge, or upon a
  /// neighbour.
  void fold() {
    for (int axis = 0; axis < 3; ++axis)
      X(axis, corner(0)) = X(axis, corner(1)) + X(axis, corner(2)) - X(axis, corner(0));
  }
  void collapse() {
    for (int axis = 0; axis < 3; ++axis) X(axis, corner(0)) = X(axis, corner(1));
  }

 private:
  [[nodiscard]] std::int32_t vertices() const { return static_cast<std::int32_t>(cells_.vertices()); }
  [[nodiscard]] std::int32_t corner(int k) const {
    const Triangles& t = cells_.triangles;
    return (k == 0 ? t.a : k == 1 ? t.b : t.c)[0];
  }
  PersistentState list_;
  const Cells& cells_;
};

/// How the loop ends that goes on from the spoiled state. Collective; the run directory is rank 0's.
Error end_of_spoiled_run(const SmallRun& run, const Communicator& comm, const std::function<void(State&)>& spoil) {
  FileSystem& files = posix_file_system();
  std::string directory = run.path("").string();
  comm.broadcast(directory);
  const Setup setup = set_up(run.path("run.ini"), files);
  const Decomposition decomposition(setup.lattice.lattice, comm);
  const std::unique_ptr<Simulation> simulation = make_simulation(setup, comm, decomposition);
  simulation->start();
  State state(*simulation);
  spoil(state);
  simulation->resume();
  std::optional<Attempt> attempt;
  if (comm.is_root()) attempt = Attempt::claim(files, directory);
  RunLoop loop({setup,
                comm,
                *simulation,
                files,
                directory,
                attempt ? &*attempt : nullptr,
                nullptr,
                simulation->mesh_digest(),
                {},
                true},
               0);
  try {
    static_cast<void>(loop.run());
  } catch (const Error& error) {
    return error;
  }
  return {Exit::finished, ""};
}

struct Failure {
  const char* name;
  std::function<void(State&)> spoil;
  std::vector<std::string> words;  ///< place and value, beside what each message holds
};

void PrintTo(const Failure& failure, std::ostream* out) { *out << failure.name; }

class FailedPhysics : public ::testing::TestWithParam<Failure> {};

TEST_P(FailedPhysics, Is70AndSaysWhenWhereHowMuchAndWhatToTry) {
  const SmallRun run(Changes{{"numerics.kernel", "2-point"}, {"numerics.precision", "double"}});
  const Error error = end_of_spoiled_run(run, Communicator(MPI_COMM_SELF), GetParam().spoil);
  EXPECT_EQ(error.code(), Exit::physics) << error.what();
  for (const auto& word : GetParam().words) EXPECT_THAT(error.what(), HasSubstr(word));
  for (const char* word : {"step 0: ", ". Try ", "smaller ", "held with ", "kernel = 4-point",
                           "; last good checkpoint: checkpoints/000000000000.h5."})
    EXPECT_THAT(error.what(), HasSubstr(word));

  const Communicator all;
  const Error error_of_all = end_of_spoiled_run(run, all, GetParam().spoil);
  EXPECT_EQ(error_of_all.code(), Exit::physics);
  EXPECT_STREQ(error_of_all.what(), error.what());
  all.barrier();  // rank 0 removes the run directory
}

const std::vector<Failure> failures = {
    {"FlowNotFinite",
     [](State& s) { s.add(0, std::numeric_limits<double>::quiet_NaN()); },
     {"at node (21, 15, 12) the flow is not finite (density nan"}},
    {"FlowTooFast",
     [](State& s) {
       s.add(1, 0.1);
       s.add(2, -0.1);
     },
     {"at node (21, 15, 12) the velocity is Mach 0.3", "above 0.1 (bounds.max_mach)"}},
    {"DensityOutOfBounds", [](State& s) { s.add(0, 1.5); }, {"at node (21, 15, 12) the density is 2.5 of the mean"}},
    {"VertexNotFinite",
     [](State& s) { s.X(1, 7) = std::numeric_limits<double>::infinity(); },
     {"cell 0, triangle", "vertex 7 is not finite", "inf"}},
    {"MeshFolded", [](State& s) { s.fold(); }, {"cell 0, triangle", "are folded", "near (", "limit -0.98"}},
    {"TriangleCollapsed",
     [](State& s) { s.collapse(); },
     {"cell 0, triangle", "collapsed to 0", "near (", "limit 0.02"}},
    {"CellThroughAWall",
     [](State& s) { s.shift(2, 8); },
     {"of cell 0 has gone through the high z wall: it is at (", "the wall at 14.5"}},
    {"AreaOutOfBounds", [](State& s) { s.scale(1.3); }, {"cell 0 at (", ") node spacings: its area is 1.69"}},
    {"VolumeOutOfBounds",
     [](State& s) { s.scale(1.09); },
     {"cell 0 at (", ") node spacings: its volume is 1.29", "at most 0.1 off"}},
    {"TooManyNodesInside", [](State& s) { s.scale(0.86); }, {"the flagged nodes fill 1.6", "cell 0 is at ("}},
};

INSTANTIATE_TEST_SUITE_P(, FailedPhysics, ::testing::ValuesIn(failures),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace rouleau::testing
