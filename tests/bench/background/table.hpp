// The rows of the background's benchmark: what, wanted, reached.
#pragma once

#include <filesystem>
#include <string>

namespace rigsound::bench {

class Table {
 public:
  Table();  ///< prints the heading

  /// A row whose `reached` must not lie over `wanted`.
  void at_most(const std::string& what, double wanted, double reached, const char* unit);
  void at_least(const std::string& what, double wanted, double reached, const char* unit);
  /// A row that no bound belongs to.
  void note(const std::string& what, double reached, const char* unit) const;
  /// A row that could not be measured.
  void skip(const std::string& what, const std::string& reason) const;

  bool held() const { return held_; }  ///< every bound so far

 private:
  bool held_ = true;
};

void transform_rows(Table& table);
void run_time_rows(Table& table);
void simulator_rows(Table& table);
void blow_rows(Table& table);
/// Rows of real recordings, skipped where `data` does not hold them.
void recording_rows(Table& table, const std::filesystem::path& data);
void note_rows(Table& table, const std::filesystem::path& data);

}  // namespace rigsound::bench
