// SPDX-License-Identifier: BSD-3-Clause
// Every way in which bytes from outside get into the two programs, as functions of the bytes.
#pragma once

#include <array>
#include <string_view>

namespace rouleau::fuzz {

/// Takes the bytes in and returns, or throws one of the programs' two Error types. Whatever else happens (another
/// exception, a crash, a report of a sanitizer, a time or a memory without bound) is a defect.
using Read = void (*)(std::string_view bytes);

void read_run_file(std::string_view bytes);
void read_off(std::string_view bytes);
void read_stl(std::string_view bytes);
void read_manifest(std::string_view bytes);
void read_metadata(std::string_view bytes);
/// A checkpoint file as a whole.
void read_checkpoint(std::string_view bytes);
/// Manifest and metadata, separated by a zero byte, inside an otherwise sound file. `mmmmmmmmmmmmmmmm` in the manifest
/// stands for the metadata's checksum.
void read_checkpoint_texts(std::string_view bytes);
void read_solver_log(std::string_view bytes);

void read_study(std::string_view bytes);
void read_campaign_log(std::string_view bytes);
/// exit.json, process.json, progress.json, job, status: each reader sees the same bytes.
void read_records(std::string_view bytes);
void read_point_file(std::string_view bytes);
void read_check_reply(std::string_view bytes);
/// A cluster file, and the job script that comes of it.
void read_cluster_file(std::string_view bytes);
/// What sbatch, squeue and their error streams say.
void read_scheduler(std::string_view bytes);

struct Format {
  std::string_view name;  ///< of its folder in corpus/
  Read read;
};

inline constexpr std::array<Format, 15> formats{{
    {"run_file", read_run_file},
    {"off", read_off},
    {"stl", read_stl},
    {"manifest", read_manifest},
    {"metadata", read_metadata},
    {"checkpoint", read_checkpoint},
    {"checkpoint_texts", read_checkpoint_texts},
    {"solver_log", read_solver_log},
    {"study", read_study},
    {"campaign_log", read_campaign_log},
    {"records", read_records},
    {"point", read_point_file},
    {"check_reply", read_check_reply},
    {"cluster", read_cluster_file},
    {"scheduler", read_scheduler},
}};

}  // namespace rouleau::fuzz
