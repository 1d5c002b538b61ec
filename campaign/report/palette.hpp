// SPDX-License-Identifier: BSD-3-Clause
// The colours of all figures: those of Okabe and Ito, which the colour-blind tell apart. Colour never speaks alone.
#pragma once

#include <array>
#include <string_view>

namespace rouleau::campaign {

inline constexpr std::string_view blue = "#0072B2", vermillion = "#D55E00", green = "#009E73", purple = "#CC79A7",
                                  orange = "#E69F00", sky = "#56B4E9", black = "#000000", grey = "#767676";

/// How a class looks: a colour and a shape of gnuplot's (filled when the point is done, open before).
struct ClassLook {
  std::string_view name, colour;
  int filled = 0, open = 0;  ///< point types
  std::string_view sign;     ///< the shape as a character, for text
};

inline constexpr std::array<ClassLook, 3> class_looks = {{{"croissant", blue, 7, 6, "\u25CF"},
                                                          {"slipper", vermillion, 9, 8, "\u25B2"},
                                                          {"undecided", "#595959", 5, 4, "\u25A0"}}};

/// Curves that are told apart one by one: the colours in turn, each round with another dash.
inline constexpr std::array<std::string_view, 7> curve_colours = {blue, vermillion, green, purple, orange, sky, black};

}  // namespace rouleau::campaign
