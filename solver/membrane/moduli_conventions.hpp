// SPDX-License-Identifier: BSD-3-Clause
// The three ways in which the Skalak moduli are written in the literature, and how they convert.
//
//   kappa_S   W = kappa_S/12 (I1^2 + 2 I1 - 2 I2) + kappa_A/12 I2^2      [Krueger], and the code inside
//   G_s       W = G_s/4 (I1^2 + 2 I1 - 2 I2 + C I2^2)                     [Barthes-Biesel]
//   B         W = B/4 (I1^2/2 + I1 - I2) + C_B/8 I2^2                     [Lehmann2020] Eq. 8
//
// Equal energies: kappa_S = 3 G_s = 1.5 B, and C = kappa_A/kappa_S = C_B/B is the same number in all three.
#pragma once

namespace rouleau {

enum class ShearConvention { kappa_S, G_s, B };

/// kappa_S from a shear modulus in another convention; any unit.
constexpr double to_kappa_S(ShearConvention convention, double modulus) {
  switch (convention) {
    case ShearConvention::G_s:
      return 3.0 * modulus;
    case ShearConvention::B:
      return 1.5 * modulus;
    case ShearConvention::kappa_S:
      break;
  }
  return modulus;
}

/// The modulus in another convention from kappa_S.
constexpr double from_kappa_S(ShearConvention convention, double kappa_S) {
  return kappa_S / to_kappa_S(convention, 1.0);
}

/// Energy per reference area by kappa_S and kappa_A = C kappa_S.
constexpr double skalak_energy_kappa_S(double I1, double I2, double kappa_S, double kappa_A) {
  return kappa_S / 12 * (I1 * I1 + 2 * I1 - 2 * I2) + kappa_A / 12 * I2 * I2;
}

/// Energy per reference area by G_s and C = kappa_A / kappa_S.
constexpr double skalak_energy_G_s(double I1, double I2, double G_s, double C) {
  return G_s / 4 * (I1 * I1 + 2 * I1 - 2 * I2 + C * I2 * I2);
}

/// Energy per reference area by the paper's B and C_B = C B.   [Lehmann2020] Eq. 8
constexpr double skalak_energy_B(double I1, double I2, double B, double C_B) {
  return B / 4 * (0.5 * I1 * I1 + I1 - I2) + C_B / 8 * I2 * I2;
}

}  // namespace rouleau
