// SPDX-License-Identifier: BSD-3-Clause
// Files of a run.
#include "run_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

namespace fake {

namespace fs = std::filesystem;

namespace {

constexpr const char* header =
    "step,time_s,cell,d_um,x_um,y_um,z_um,asphericity,volume_ratio,area_ratio,inclination_deg,inside_nodes,inside_"
    "ratio,"
    "flips,mean_velocity_mm_per_s,pressure_gradient_Pa_per_m,velocity_x_mm_per_s,taylor_deformation,angle_xz_deg,"
    "angle_xy_deg,extent_x_um,extent_y_um,extent_z_um,marker_y_dx_um,marker_y_dy_um,marker_y_dz_um,marker_z_dx_um,"
    "marker_z_dy_um,marker_z_dz_um,check\n";

int newest_attempt() {
  int newest = 0;
  if (!fs::exists("attempts")) return 0;
  for (const auto& entry : fs::directory_iterator("attempts")) {
    newest = std::max(newest, std::atoi(entry.path().filename().c_str()));
  }
  return newest;
}

std::string hash_of(const std::string& text) { return fmt::format("{:016x}", XXH64(text.data(), text.size(), 0)); }

}  // namespace

double unix_s() { return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count(); }

void write_whole(const fs::path& file, const std::string& text) {
  const std::string aside = file.string() + ".tmp";
  const int fd = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  const bool is_written = fd >= 0 && ::write(fd, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  if (fd >= 0) ::close(fd);
  if (!is_written || std::rename(aside.c_str(), file.c_str()) != 0)
    throw Failure(74, file.string() + ": cannot be written.");
}

std::string read_whole(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

Attempt::Attempt(int number, std::string token) : number_(number), token_(std::move(token)) {
  if (number_ != 0) return;
  number_ = newest_attempt() + 1;
  token_ = hash_of(std::to_string(unix_s()));
  fs::create_directories(directory());
  write_whole(directory() / "owner", token_ + "\n");
}

fs::path Attempt::directory() const { return fs::path("attempts") / std::to_string(number_); }

void Attempt::check_fence() const {
  if (newest_attempt() != number_ || read_whole(directory() / "owner") != token_ + "\n") {
    throw Failure(76, "superseded by a newer attempt");
  }
}

Position newest_checkpoint() {
  Position newest{-1, 0};
  if (!fs::exists("checkpoints")) return newest;
  for (const auto& entry : fs::directory_iterator("checkpoints")) {
    if (entry.path().extension() != ".h5") continue;
    Position position;
    if (std::sscanf(read_whole(entry.path()).c_str(), "%lld %lld", &position.step, &position.log_bytes) != 2) continue;
    if (position.step > newest.step) newest = position;
  }
  return newest;
}

void write_checkpoint(const Attempt& attempt, const Position& position, int kept) {
  attempt.check_fence();
  fs::create_directories("checkpoints");
  write_whole(fmt::format("checkpoints/{:012d}.h5", position.step),
              fmt::format("{} {}\n", position.step, position.log_bytes));
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator("checkpoints")) {
    if (entry.path().extension() == ".h5") all.push_back(entry.path());
  }
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i + static_cast<std::size_t>(kept) < all.size(); ++i) fs::remove(all[i]);
}

void cut_samples(Position& position) {
  if (position.step < 0) position.step = 0;
  if (position.log_bytes > 0) {
    fs::resize_file("samples.csv", static_cast<std::uintmax_t>(position.log_bytes));
    return;
  }
  std::ofstream("samples.csv", std::ios::binary | std::ios::trunc) << header;
  position.log_bytes = static_cast<long long>(std::string(header).size());
}

std::string sample_line(const RunFile& run, long long step) {
  const double t = static_cast<double>(step) * run.number("numerics.time_step_us") * 1e-6;
  const double lambda = run.number("fluid.lambda");
  const double d = lambda > 4.75 ? 1.0 + 0.1 * std::sin(60 * t) : 0.5 * std::exp(-30 * t);
  const double turned = 60 * t;  // the marker of z goes around once in 0.1 s
  const std::string line =
      fmt::format("{},{},0,{},{},{},0,0.15,1,1.01,10,500,1.0,0,1.5,100,{},0.2,15,0,8,8,4,0,4,0,{},0,{}", step, t, d,
                  1500 * t, d, 1.5 + 0.01 * lambda, 3 * std::sin(turned), 3 * std::cos(turned));
  return line + "," + hash_of(line) + "\n";
}

}  // namespace fake
