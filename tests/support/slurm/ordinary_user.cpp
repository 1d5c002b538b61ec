// SPDX-License-Identifier: BSD-3-Clause
// main() of tests with a real Slurm. Root becomes an ordinary user first, as people who use a cluster are, unless that
// user cannot reach the programs (a checkout in root's home): then all runs as root, which Slurm allows, too.
#include <grp.h>
#include <gtest/gtest.h>
#include <pwd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace {

bool become(const passwd& user) {
  return ::setgroups(0, nullptr) == 0 && ::setgid(user.pw_gid) == 0 && ::setuid(user.pw_uid) == 0;
}

bool can_run_programs(const passwd& user) {
  const pid_t child = ::fork();
  if (child == 0) {
    bool can = become(user);
    for (const char* program : {ROULEAU_PROGRAM, REAL_SOLVER_PROGRAM, SLURM_SANDBOX_PROGRAM}) {
      can = can && ::access(program, R_OK | X_OK) == 0;
    }
    ::_exit(can ? 0 : 1);
  }
  int status = 1;
  ::waitpid(child, &status, 0);
  return status == 0;
}

}  // namespace

int main(int count, char** arguments) {
  const passwd* user = ::getuid() == 0 ? ::getpwnam("nobody") : nullptr;
  if (user != nullptr && can_run_programs(*user)) {
    if (!become(*user)) return 99;
    ::setenv("HOME", "/tmp", 1);
    ::setenv("USER", user->pw_name, 1);
    if (::chdir("/tmp") != 0) return 99;
  }
  std::printf("Slurm runs as user %u\n", static_cast<unsigned>(::getuid()));
  // MPI ranks of one node need no network; nothing of these tests listens on one.
  ::setenv("OMPI_MCA_btl", "self,vader", 1);
  ::setenv("OMPI_MCA_oob_tcp_if_include", "lo", 1);
  ::testing::InitGoogleTest(&count, arguments);
  return RUN_ALL_TESTS();
}
