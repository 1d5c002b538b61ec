// SPDX-License-Identifier: BSD-3-Clause
// Collective operations over MPI, and the rule that one rank's error is everybody's.
#include "parallel/communicator.hpp"

#include <climits>
#include <cstdio>
#include <optional>

#include "base/error.hpp"

namespace rouleau {

MpiSession::MpiSession(int* argc, char*** argv) { MPI_Init(argc, argv); }
MpiSession::~MpiSession() { MPI_Finalize(); }

Communicator::Communicator(MPI_Comm comm) : comm_(comm) {
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &size_);
}

void Communicator::barrier() const { MPI_Barrier(comm_); }

void Communicator::broadcast(std::string& text) const {
  std::int64_t length = static_cast<std::int64_t>(text.size());
  MPI_Bcast(&length, 1, MPI_INT64_T, 0, comm_);
  text.resize(static_cast<std::size_t>(length));
  broadcast(text.data(), text.size());
}

void Communicator::broadcast(void* bytes, std::size_t count) const {
  constexpr std::size_t piece = std::size_t{1} << 30;  // MPI counts are int
  auto* p = static_cast<char*>(bytes);
  for (std::size_t done = 0; done < count; done += piece)
    MPI_Bcast(p + done, static_cast<int>(std::min(piece, count - done)), MPI_BYTE, 0, comm_);
}

void Communicator::sum(std::int64_t* values, int count) const {
  if (size_ > 1) MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_INT64_T, MPI_SUM, comm_);
}

std::int64_t Communicator::sum(std::int64_t value) const {
  sum(&value, 1);
  return value;
}

std::int64_t Communicator::min(std::int64_t value) const {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT64_T, MPI_MIN, comm_);
  return value;
}

std::int64_t Communicator::max(std::int64_t value) const {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT64_T, MPI_MAX, comm_);
  return value;
}

double Communicator::max(double value) const {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, comm_);
  return value;
}

void Communicator::all_agree(const std::function<void()>& work) const {
  std::optional<Error> error;
  try {
    work();
  } catch (const Error& e) {
    error = e;
  } catch (const std::exception& e) {
    error = Error(Exit::internal, fmt::format("internal error on rank {}: {}", rank_, e.what()));
  }
  int failing = error ? rank_ : INT_MAX;
  MPI_Allreduce(MPI_IN_PLACE, &failing, 1, MPI_INT, MPI_MIN, comm_);
  if (failing == INT_MAX) return;

  int code = error ? static_cast<int>(error->code()) : 0;
  int length = error ? static_cast<int>(std::string(error->what()).size()) : 0;
  MPI_Bcast(&code, 1, MPI_INT, failing, comm_);
  MPI_Bcast(&length, 1, MPI_INT, failing, comm_);
  std::string message = rank_ == failing ? error->what() : std::string(static_cast<std::size_t>(length), ' ');
  MPI_Bcast(message.data(), length, MPI_CHAR, failing, comm_);
  throw Error(static_cast<Exit>(code), message);
}

int Communicator::or_end_all(const std::function<int()>& work) const {
  try {
    return work();
  } catch (const std::exception& error) {
    fmt::print(stderr, "rouleau-solver: rank {}: {}. All ranks end here; start the run again.\n", rank_, error.what());
    std::fflush(stderr);
    const int code = static_cast<int>(Exit::internal);
    MPI_Abort(comm_, code);
    return code;
  }
}

void Communicator::on_root(const std::function<void()>& work) const {
  all_agree([&] {
    if (is_root()) work();
  });
}

}  // namespace rouleau
