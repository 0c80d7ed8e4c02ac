#include "report/report_section.hpp"

namespace rigsound::analysis {

std::string report_section(const Part& part, const PartAnalysis&) {
  return "<section id=\"" + part.bank + "\"></section>";
}

}  // namespace rigsound::analysis
