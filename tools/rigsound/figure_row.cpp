#include "figure_row.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace rigsound::tools {

FigureRow& FigureRow::add(const char* name, double value, const char* format) {
  figures_.push_back({name, std::isnan(value) ? "" : fmt::format(fmt::runtime(format), value),
                      std::isfinite(value) ? Json(value) : Json()});
  return *this;
}

FigureRow& FigureRow::add(const char* name, std::string value) {
  figures_.push_back({name, value, std::move(value)});
  return *this;
}

FigureRow& FigureRow::add_text(const char* name, std::string text, double value) {
  figures_.push_back({name, std::move(text), value});
  return *this;
}

FigureRow& FigureRow::add_count(const char* name, std::size_t value) {
  figures_.push_back({name, std::to_string(value), value});
  return *this;
}

FigureRow& FigureRow::add_flag(const char* name, bool value) {
  figures_.push_back({name, value ? "yes" : "no", value});
  return *this;
}

FigureRow FigureRow::operator+(const FigureRow& more) const {
  FigureRow both = *this;
  both.figures_.insert(both.figures_.end(), more.figures_.begin(), more.figures_.end());
  return both;
}

std::string FigureRow::words() const {
  std::string text;
  for (const Figure& figure : figures_) text += (text.empty() ? "" : " ") + figure.name + "=" + figure.text;
  return text;
}

std::string FigureRow::lines() const {
  std::string text;
  for (const Figure& figure : figures_) text += figure.name + " " + figure.text + "\n";
  return text;
}

std::string FigureRow::csv_head() const {
  std::string text;
  for (const Figure& figure : figures_) text += (text.empty() ? "" : ",") + figure.name;
  return text + "\n";
}

std::string FigureRow::csv() const {
  std::string text;
  for (const Figure& figure : figures_) text += (&figure == &figures_.front() ? "" : ",") + figure.text;
  return text + "\n";
}

Json FigureRow::json() const {
  Json object = Json::object();
  for (const Figure& figure : figures_) object[figure.name] = figure.value;
  return object;
}

Json json_list(const std::vector<FigureRow>& rows) {
  Json list = Json::array();
  for (const FigureRow& row : rows) list.push_back(row.json());
  return list;
}

void print_document(const Json& json, std::FILE* to) { fmt::print(to, "{}\n", config::json_lines(json)); }

}  // namespace rigsound::tools
