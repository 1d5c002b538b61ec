// SPDX-License-Identifier: BSD-3-Clause
// The lock of a campaign: held by an open file, so that it frees itself when its holder dies.
#pragma once

#include <filesystem>
#include <string>

namespace rouleau::campaign {

/// Exclusive while it lives. The text in the file only tells people who holds it.
class CampaignLock {
 public:
  /// Takes DIR/.lock.   throws Error (locked) naming the holder if another live process has it
  CampaignLock(const std::filesystem::path& directory, const std::string& verb);
  CampaignLock(const CampaignLock&) = delete;
  CampaignLock& operator=(const CampaignLock&) = delete;
  ~CampaignLock();

 private:
  int fd_;
};

}  // namespace rouleau::campaign
