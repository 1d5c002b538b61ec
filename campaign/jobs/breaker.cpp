// SPDX-License-Identifier: BSD-3-Clause
// Counting like failures.
#include "jobs/breaker.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace rouleau::campaign {

namespace {

std::string without_numbers(const std::string& text) {
  std::string shape;
  for (const unsigned char c : text) {
    if (std::isdigit(c) != 0) {
      if (shape.empty() || shape.back() != '0') shape += '0';
    } else {
      shape += static_cast<char>(c);
    }
  }
  return shape;
}

}  // namespace

Breaker::Breaker(int limit, const std::string& kept) : limit_(limit) {
  std::istringstream lines(kept);
  std::string reason, point;
  std::getline(lines, reason);
  while (lines >> point) note_failure(point, reason);
}

std::string Breaker::text() const {
  if (points_.empty()) return "";
  std::string text = reason_;
  std::replace(text.begin(), text.end(), '\n', ' ');
  text += '\n';
  for (const std::string& point : points_) text += point + ' ';
  return text;
}

void Breaker::note_failure(const std::string& point, const std::string& reason) {
  if (has_tripped()) return;
  const std::string shape = without_numbers(reason);
  if (shape != shape_) points_.clear();
  shape_ = shape;
  reason_ = reason;
  points_.insert(point);
}

void Breaker::note_progress() {
  if (!has_tripped()) reset();
}

void Breaker::reset() {
  points_.clear();
  shape_.clear();
}

}  // namespace rouleau::campaign
