// SPDX-License-Identifier: BSD-3-Clause
// The libFuzzer program: `fuzz --format=off CORPUS` (share/fuzz.sh runs it for every format).
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "base/error.hpp"
#include "fuzz/formats.hpp"
#include "study/error.hpp"

namespace {

using namespace rouleau::fuzz;

Read read_one = nullptr;

[[noreturn]] void explain() {
  std::fputs("fuzz: say what to read, as the first word: --format=", stderr);
  for (const Format& format : formats) std::fprintf(stderr, "%s ", format.name.data());
  std::fputs("\n", stderr);
  std::exit(64);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  const std::string_view word = *argc > 1 ? (*argv)[1] : "";
  constexpr std::string_view option = "--format=";
  const auto* wanted = std::find_if(formats.begin(), formats.end(), [&](const Format& format) {
    return word.starts_with(option) && word.substr(option.size()) == format.name;
  });
  if (wanted == formats.end()) explain();
  read_one = wanted->read;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    read_one({reinterpret_cast<const char*>(data), size});
  } catch (const rouleau::Error&) {  // refused with a message
  } catch (const rouleau::campaign::Error&) {
  }
  return 0;
}
