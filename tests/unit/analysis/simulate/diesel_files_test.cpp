// The simulated diesel's files: the angle that is told is the integral of the speed that is told.
#include <doctest/doctest.h>

#include <cmath>

#include "rigsound/analysis/time_table.hpp"
#include "simulate/diesel_body.hpp"
#include "simulate/diesel_files.hpp"
#include "simulate/diesel_recording.hpp"
#include "temporary_folder.hpp"

using namespace rigsound::analysis;

TEST_CASE("a glide spends the same time in every octave") {
  const std::vector<double> rpm = glide_rpm(600, 2400, 1);
  CHECK(rpm.front() == doctest::Approx(600));
  CHECK(rpm[rpm.size() / 2] == doctest::Approx(1200));
  CHECK(rpm.back() == doctest::Approx(2400).epsilon(1e-4));
}

TEST_CASE("the diesel's files agree with one another and with the body") {
  const rigsound::test::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path / "engine");
  std::filesystem::create_directories(folder.path / "truth");
  DieselFilesOptions brief;
  brief.seed = 3, brief.sweep_s = 8, brief.idle_s = 1;
  CHECK(write_diesel(folder.path, brief).size() == 2);

  const TimeTable rpm = read_time_table(folder.path / "engine" / "sweep_rpm.csv", "rpm");
  const TimeTable angle = read_time_table(folder.path / "truth" / "sweep_angle.csv", "cycles");
  REQUIRE(rpm.value.size() == angle.value.size());
  double turned = 0;  // cycles of 720 degrees, by the trapezium rule
  for (std::size_t i = 1; i < rpm.value.size(); ++i)
    turned += (rpm.value[i] + rpm.value[i - 1]) / 240 * (rpm.time_s[i] - rpm.time_s[i - 1]);
  // The speed wanders by 0.3 % around what the instruments say.
  CHECK(angle.value.back() - angle.value.front() == doctest::Approx(turned).epsilon(0.005));

  const auto body = folder.path / "truth" / "engine_body.csv";
  std::ifstream rows(body);
  std::string heading;
  std::getline(rows, heading);
  CHECK(heading == "frequency_hz,gain_db");
  double f_hz = 0, gain_db = 0;
  char comma = 0;
  int count = 0;
  for (; rows >> f_hz >> comma >> gain_db; ++count)
    CHECK(gain_db == doctest::Approx(simulated_body_db(f_hz)).epsilon(0.001).scale(1));
  CHECK(count > 160);
}
