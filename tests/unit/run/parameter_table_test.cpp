// SPDX-License-Identifier: BSD-3-Clause
// The table of parameters, and the example run file that it writes.
#include "run/parameter_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "run/value_text.hpp"
#include "unit/run/run_text.hpp"

namespace rouleau {
namespace {

TEST(ParameterTable, NamesEachParameterOnceAndExplainsIt) {
  std::set<std::string> names;
  for (const auto& p : parameter_table()) {
    EXPECT_TRUE(names.insert(p.full_name()).second) << p.full_name();
    EXPECT_FALSE(p.help.empty()) << p.full_name();
    EXPECT_FALSE(p.default_text.empty() && p.example.empty()) << p.full_name();
  }
}

TEST(ParameterTable, HasDefaultsAndExamplesWithinTheirRanges) {
  for (const auto& p : parameter_table())
    for (const auto text : {p.default_text, p.example}) {
      if (text.empty()) continue;
      if (p.type == ParameterType::choice) {
        EXPECT_NE(std::find(p.choices.begin(), p.choices.end(), text), p.choices.end()) << p.full_name();
      }
      if (p.type == ParameterType::real || p.type == ParameterType::integer) {
        EXPECT_GE(parse_real(text), p.min) << p.full_name();
        EXPECT_LE(parse_real(text), p.max) << p.full_name();
      }
    }
}

TEST(ParameterTable, NamesSelectorsOfTheSameSectionThatHaveTheChoices) {
  const auto table = parameter_table();
  for (const auto& p : table)
    for (const auto& c : p.conditions) {
      if (c.selector == "cells") continue;
      const auto selector = std::find_if(table.begin(), table.end(),
                                         [&](const auto& q) { return q.section == p.section && q.name == c.selector; });
      ASSERT_NE(selector, table.end()) << p.full_name();
      for (const auto a : c.admitted)
        EXPECT_NE(std::find(selector->choices.begin(), selector->choices.end(), a), selector->choices.end())
            << p.full_name();
    }
}

template <class E>
struct Named {
  E value;
  const char* text;
};

// The table stores the index of a choice as the enumerator: their orders must agree.
TEST(ParameterTable, OrdersChoicesLikeTheEnumerators) {
  const auto stored = [](const std::string& name, const std::string& text) {
    const auto table = parameter_table();
    const auto p = std::find_if(table.begin(), table.end(), [&](const auto& q) { return q.full_name() == name; });
    const auto chosen = std::find(p->choices.begin(), p->choices.end(), text);
    EXPECT_NE(chosen, p->choices.end()) << name << " " << text;
    RunParameters parameters;
    parameters.cells.resize(1);
    TypedValue value;
    value.choice = static_cast<std::size_t>(chosen - p->choices.begin());
    p->store(parameters, 0, value);
    return parameters;
  };
  const auto n = [&](const std::string& name, const std::string& text) {
    return stored("numerics." + name, text).numerics;
  };
  EXPECT_EQ(stored("channel.boundary_y", "periodic").channel.boundary_y, Boundary::periodic);
  EXPECT_EQ(stored("channel.boundary_z", "periodic").channel.boundary_z, Boundary::periodic);
  EXPECT_EQ(stored("flow.driving", "pressure_gradient").flow.driving, Driving::pressure_gradient);
  EXPECT_EQ(stored("flow.driving", "shear").flow.driving, Driving::shear);
  EXPECT_EQ(stored("flow.driving", "rest").flow.driving, Driving::rest);
  EXPECT_EQ(stored("flow.initial", "developed").flow.initial, InitialFlow::developed);
  EXPECT_EQ(stored("flow.initial", "uniform").flow.initial, InitialFlow::uniform);
  for (const auto& [value, text] : {Named<Shape>{Shape::red_blood_cell, "red_blood_cell"},
                                    {Shape::sphere, "sphere"},
                                    {Shape::ellipsoid, "ellipsoid"},
                                    {Shape::mesh, "mesh"},
                                    {Shape::checkpoint, "checkpoint"},
                                    {Shape::none, "none"}})
    EXPECT_EQ(stored("cell.shape", text).cells[0].shape, value);
  EXPECT_EQ(stored("cell.offset_from", "checkpoint").cells[0].offset_from, OffsetFrom::checkpoint);
  EXPECT_EQ(stored("membrane.law", "neo_hookean").membrane.law, InPlaneLaw::neo_hookean);
  for (const auto& [value, text] : {Named<StretchAxis>{StretchAxis::none, "none"},
                                    {StretchAxis::x, "x"},
                                    {StretchAxis::y, "y"},
                                    {StretchAxis::z, "z"}})
    EXPECT_EQ(stored("stretch.axis", text).stretch.axis, value);
  EXPECT_EQ(stored("cell.reference", "file").cells[0].reference, Reference::file);
  for (const auto& [value, text] : {Named<ShearConvention>{ShearConvention::kappa_S, "kappa_S"},
                                    {ShearConvention::G_s, "G_s"},
                                    {ShearConvention::B, "B"}})
    EXPECT_EQ(stored("membrane.shear_modulus_convention", text).membrane.shear_modulus_convention, value);
  EXPECT_EQ(n("precision", "double").precision, Precision::double_);
  EXPECT_EQ(n("collision", "mrt").collision, CollisionLaw::mrt);
  EXPECT_EQ(n("kernel", "2-point").kernel, KernelWidth::two_point);
  EXPECT_EQ(n("kernel", "3-point").kernel, KernelWidth::three_point);
  EXPECT_EQ(n("kernel", "4-point").kernel, KernelWidth::four_point);
  EXPECT_EQ(n("advection", "adams_bashforth").advection, Advection::adams_bashforth);
  EXPECT_EQ(n("advection", "averaged").advection, Advection::averaged);
  EXPECT_EQ(n("tracking", "vertex_normals_wide").tracking, TrackingChoice::vertex_normals_wide);
  EXPECT_EQ(n("tracking", "face_normals").tracking, TrackingChoice::face_normals);
  EXPECT_EQ(n("tracking", "off").tracking, TrackingChoice::off);
}

TEST(ExampleRunFile, WorksAsItStands) {
  const test::Read example(example_run_file());
  EXPECT_NO_THROW(example.warnings());
  EXPECT_EQ(example.lattice.lattice.size, (Int3{42, 24, 20}));
}

TEST(ExampleRunFile, ListsEveryParameterAndItsCommentedDefaultsAreTheDefaults) {
  const std::string text = example_run_file();
  const RunFile run = parse_run_file(text, "run.ini");
  for (const auto& p : parameter_table()) {
    const std::string line = std::string(p.name) + " = ";
    const bool commented = text.find("\n#" + line) != std::string::npos;
    const bool active = text.find("\n" + line) != std::string::npos;
    EXPECT_TRUE(commented || active) << p.full_name();
    EXPECT_EQ(run.value(p.full_name()).given, active) << p.full_name();
  }
}

}  // namespace
}  // namespace rouleau
