// SPDX-License-Identifier: BSD-3-Clause
// The lock of a campaign: held by an open file, so that it frees itself when its holder dies.
#pragma once

#include <filesystem>
#include <string>

namespace rouleau::campaign {

/// How long to wait for another pass to end; `rouleau run` is never waited for, since it makes the passes itself.
struct LockPatience {
  double seconds = 0;
};

/// Exclusive while it lives. The text in the file only tells people who holds it.
class CampaignLock {
 public:
  /// Takes DIR/.lock.   throws Error (locked) naming the holder if another live process has it
  CampaignLock(const std::filesystem::path& directory, const std::string& verb, LockPatience patience = {});
  CampaignLock(const CampaignLock&) = delete;
  CampaignLock& operator=(const CampaignLock&) = delete;
  ~CampaignLock();

 private:
  int fd_;
};

}  // namespace rouleau::campaign
