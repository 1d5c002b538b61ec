// SPDX-License-Identifier: BSD-3-Clause
// One rank runs out of memory while the others wait for it.
#include <new>

#include "parallel/communicator.hpp"

int main(int argc, char** argv) {
  const rouleau::MpiSession session(&argc, &argv);
  const rouleau::Communicator comm;
  return comm.or_end_all([&] {
    if (comm.rank() == 1) throw std::bad_alloc();
    comm.barrier();
    return 0;
  });
}
