#include "rigsound/analysis/time_table.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/number_of.hpp"

namespace rigsound::analysis {
namespace {

constexpr std::size_t kMostBytes = 256 << 20;  // eight hours of rows 2 ms apart are less

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> found(1);
  for (const char c : line) {
    if (c == ',' || c == ';')
      found.emplace_back();
    else if (c != '\r' && c != ' ')
      found.back() += c;
  }
  return found;
}

}  // namespace

TimeTable read_time_table(const std::filesystem::path& file, std::string_view column) {
  const InputFile input(file, "CSV file", kMostBytes);
  std::ifstream in(input.path());
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> heading = cells(line);
  const auto place = [&](std::string_view wanted) {
    const auto found = std::find(heading.begin(), heading.end(), wanted);
    if (found == heading.end())
      throw InputError(input.name(), 1, wanted,
                       "is no column of this file, expected a heading such as time_s," + std::string(column));
    return static_cast<std::size_t>(found - heading.begin());
  };
  const std::size_t time_at = place("time_s"), value_at = place(column);

  TimeTable table;
  for (int number = 2; std::getline(in, line); ++number) {
    if (line.empty() || line == "\r") continue;
    const std::vector<std::string> row = cells(line);
    const auto value = [&](std::size_t at) {
      const std::string text = at < row.size() ? row[at] : "";
      const auto x = number_of<double>(text);
      if (!x || !std::isfinite(*x))
        throw InputError(input.name(), number, heading[at], "'" + text + "' is no number");
      return *x;
    };
    table.time_s.push_back(value(time_at)), table.value.push_back(value(value_at));
    if (table.time_s.size() > 1 && table.time_s.back() < table.time_s[table.time_s.size() - 2])
      throw InputError(input.name(), number, "time_s", "falls back, expected ascending times");
  }
  if (table.time_s.empty()) throw InputError(input.name(), "holds no row, expected at least one");
  return table;
}

std::vector<double> at_every_sample(const TimeTable& table, std::size_t samples, double from_s) {
  std::vector<double> y(samples);
  std::size_t row = 0;
  for (std::size_t n = 0; n < samples; ++n) {
    const double t = from_s + static_cast<double>(n) / kAnalysisRate;
    while (row + 1 < table.time_s.size() && table.time_s[row + 1] <= t) ++row;
    const bool last = row + 1 == table.time_s.size();
    if (last || t <= table.time_s[row]) {
      y[n] = table.value[row];
      continue;
    }
    const double way = (t - table.time_s[row]) / (table.time_s[row + 1] - table.time_s[row]);
    y[n] = table.value[row] + (table.value[row + 1] - table.value[row]) * way;
  }
  return y;
}

}  // namespace rigsound::analysis
