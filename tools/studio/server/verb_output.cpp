#include "verb_output.hpp"

#include "child_process.hpp"
#include "http.hpp"
#include "neighbour.hpp"

namespace rigsound::studio {

std::string verb_output(const std::vector<std::string>& words) {
  constexpr std::size_t kMostBytes = 64 << 20;
  std::vector<std::string> command = {tools::neighbour("rigsound").string()};
  command.insert(command.end(), words.begin(), words.end());
  ChildProcess child(command);
  std::string text;
  const ChildProcess::Ending ending = child.run([&](const std::string& line) {
    if (text.size() > kMostBytes) return child.stop();
    text += line + "\n";
  });
  if (text.size() > kMostBytes) throw ApiError(422, words.front() + ": says more than a page can show");
  if (ending.code != 0)
    throw ApiError(422, ending.errors.empty()
                            ? words.front() + ": ended with code " + std::to_string(ending.code)
                            : ending.errors.back());
  return text;
}

}  // namespace rigsound::studio
