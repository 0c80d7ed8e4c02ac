// Target modes against exact free-free Timoshenko, Rayleigh-Love, and three-dimensional elasticity.
#include "tool/design/mode_law.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include "engine/heard.hpp"
#include "engine/tool/design/elastic_modes.hpp"

using namespace rigsound;
using namespace rigsound::tool;
using namespace rigsound::tests;

TEST_CASE("transversal targets are the exact Timoshenko modes, within a cent of elasticity") {
  for (const ReferenceBar& reference : kTransversalReference) {
    const TransversalLaw law(reference.bar);
    for (std::size_t i = 0; i < reference.rod.size(); ++i) {
      const double hz = law.at(static_cast<double>(i) + 1);
      CAPTURE(reference.bar.length_m);
      CAPTURE(i + 1);
      CHECK(std::fabs(hz - reference.rod[i]) < 0.006);
      CHECK(std::fabs(cents(hz, reference.elastic[i])) < 1.0);
    }
  }
}

TEST_CASE("longitudinal targets are Rayleigh-Love's, within 0.6 cent of elasticity") {
  for (const ReferenceBar& reference : kLongitudinalReference) {
    const LongitudinalLaw law(reference.bar);
    for (std::size_t i = 0; i < reference.rod.size(); ++i) {
      const double hz = law.at(static_cast<double>(i) + 1);
      CHECK(std::fabs(hz - reference.rod[i]) < 0.06);
      CHECK(std::fabs(cents(hz, reference.elastic[i])) < 0.6);
    }
  }
}

TEST_CASE("mode laws rise, and their density is the slope between neighbours") {
  for (const Bar bar : {Bar{0.3, 0.05}, Bar{0.5, 0.025}, Bar{1.0, 0.015}}) {
    const TransversalLaw bending(bar);
    const LongitudinalLaw stretching(bar);
    for (const ModeLaw* law :
         {static_cast<const ModeLaw*>(&bending), static_cast<const ModeLaw*>(&stretching)}) {
      for (double kappa = 0.5; kappa < 40; kappa += 0.25) CHECK(law->at(kappa + 0.25) > law->at(kappa));
      const int below = law->count_below(18000);
      CHECK(law->at(below) < 18000);
      CHECK(law->at(below + 1) >= 18000);
      CHECK(law->density(1.5) * (law->at(2) - law->at(1)) == doctest::Approx(1).epsilon(0.05));
    }
  }
}
