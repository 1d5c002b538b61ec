// SPDX-License-Identifier: BSD-3-Clause
// A capsule in shear as its campaign left it: its dimensionless numbers, and its measures at a given strain.
#pragma once

#include <string>

#include "campaign_run.hpp"

namespace rouleau::validation {

class CapsulePoint {
 public:
  explicit CapsulePoint(const CampaignPoint& point) : point_(&point) {}

  [[nodiscard]] double nodes_per_radius() const;
  /// mu gamma (a + excess) / G_s: a membrane that acts on the fluid through a kernel is as large as the sphere with its
  /// drag, and the excess of the hydrodynamic radius is that of the case sphere_drag.   throws Error(bad_input) unless
  /// the study gives its modulus as G_s
  [[nodiscard]] double capillary_number() const;
  [[nodiscard]] double lambda() const { return point_->number("lambda"); }

  /// A column of the samples at the strain gamma t, linear between samples.
  /// throws Error(bad_input) if the run ended before
  [[nodiscard]] double at_strain(const std::string& column, double strain) const;
  [[nodiscard]] double deformation(double strain) const { return at_strain("taylor_deformation", strain); }
  [[nodiscard]] double angle_rad(double strain) const;
  /// The last sample's.
  [[nodiscard]] double final_deformation() const { return point_->series("taylor_deformation").back(); }
  [[nodiscard]] double final_angle_rad() const;
  /// The strain at which the deformation first reaches this share of its final value.
  [[nodiscard]] double strain_to_reach(double share) const;

  [[nodiscard]] const CampaignPoint& point() const { return *point_; }

 private:
  [[nodiscard]] double strain(std::size_t sample) const;

  const CampaignPoint* point_;
};

}  // namespace rouleau::validation
