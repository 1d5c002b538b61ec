// SPDX-License-Identifier: BSD-3-Clause
// The ranks of a run, and the few collective operations the solver uses. None of them rounds.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace rouleau {

/// Starts MPI for the life of the object.
class MpiSession {
 public:
  MpiSession(int* argc, char*** argv);
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
};

class Communicator {
 public:
  explicit Communicator(MPI_Comm comm = MPI_COMM_WORLD);
  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool is_root() const { return rank_ == 0; }
  [[nodiscard]] MPI_Comm raw() const { return comm_; }

  void barrier() const;
  void broadcast(std::string& text) const;                   ///< rank 0's
  void broadcast(void* bytes, std::size_t count) const;      ///< rank 0's
  [[nodiscard]] std::int64_t sum(std::int64_t value) const;  ///< exact
  void sum(std::int64_t* values, int count) const;           ///< exact, in place
  [[nodiscard]] std::int64_t min(std::int64_t value) const;
  [[nodiscard]] std::int64_t max(std::int64_t value) const;
  [[nodiscard]] double max(double value) const;

  /// Runs `work` on this rank; if it threw on any rank, throws the lowest failing rank's Error on all of them.
  /// Every rank must call it; `work` must not communicate unless all ranks reach the same calls.
  void all_agree(const std::function<void()>& work) const;
  /// Runs `work` on rank 0 alone; its Error becomes everybody's.
  void on_root(const std::function<void()>& work) const;
  /// Runs a rank's whole work. An exception that gets out of it is this rank's alone (no memory left, say), and the
  /// others may wait for this rank in a collective call: prints it, and ends all ranks with Exit::internal.
  [[nodiscard]] int or_end_all(const std::function<int()>& work) const;

 private:
  MPI_Comm comm_;
  int rank_ = 0, size_ = 1;
};

}  // namespace rouleau
