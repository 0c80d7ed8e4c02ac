// Figures of one thing with their names: what text and JSON are both made of.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "rigsound/config/json.hpp"

namespace rigsound::tools {

/// In the order in which they were added. A number that is none is empty in text; JSON has null for it and
/// for an infinite one. Thread: OFF.
class FigureRow {
 public:
  /// `format`: of the text, "{:.3f}" say; JSON has all digits.
  FigureRow& add(const char* name, double value, const char* format = "{:g}");
  FigureRow& add(const char* name, std::string value);
  FigureRow& add(const char* name, const char* value) { return add(name, std::string(value)); }
  FigureRow& add_text(const char* name, std::string text, double value);  ///< a number already written
  FigureRow& add_count(const char* name, std::size_t value);
  FigureRow& add_flag(const char* name, bool value);  ///< yes or no

  FigureRow operator+(const FigureRow& more) const;  ///< one row of both

  std::string words() const;     ///< "name=text name=text"
  std::string lines() const;     ///< "name text\n" each
  std::string csv_head() const;  ///< "name,name\n"
  std::string csv() const;       ///< "text,text\n"
  Json json() const;

 private:
  struct Figure {
    std::string name, text;
    Json value;
  };
  std::vector<Figure> figures_;
};

/// A list of objects. Thread: OFF.
Json json_list(const std::vector<FigureRow>& rows);

/// One document. Thread: OFF.
void print_document(const Json& json, std::FILE* to = stdout);

}  // namespace rigsound::tools
