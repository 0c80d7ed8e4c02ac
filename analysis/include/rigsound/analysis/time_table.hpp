// CSV files with a time column: rpm tracks and click lists.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace rigsound::analysis {

struct TimeTable {
  std::vector<double> time_s, value;  ///< same length, times ascending
};

/// Reads the columns `time_s` and `column` of a CSV with a heading line; other columns are passed over.
/// Errors: InputError with the line for anything that is no number, missing columns, times that fall back, no
/// row at all. Thread: OFF.
TimeTable read_time_table(const std::filesystem::path& file, std::string_view column);

/// Straight lines between the rows, held before the first and after the last: one value a sample of
/// kAnalysisRate, from `from_s` on. Thread: OFF.
std::vector<double> at_every_sample(const TimeTable& table, std::size_t samples, double from_s = 0);

}  // namespace rigsound::analysis
