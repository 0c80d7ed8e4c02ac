#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "rigsound/analysis/labels.hpp"
#include "rigsound/machine/input_error.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

/// A label file that goes away.
class LabelFile {
 public:
  explicit LabelFile(const std::string& text)
      : path_(std::filesystem::temp_directory_path() / "rigsound_labels_test.txt") {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~LabelFile() { std::filesystem::remove(path_); }
  const std::filesystem::path& path() const { return path_; }

  std::string complaint() const {
    try {
      read_labels(path_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

 private:
  std::filesystem::path path_;
};

/// Complains about `line` and `key`.
bool complains(const std::string& text, int line, const std::string& key) {
  const LabelFile file(text);
  const std::string start = file.path().string() + ":" + std::to_string(line) + ": " + key + ": ";
  const std::string complaint = file.complaint();
  INFO(complaint);
  return complaint.compare(0, start.size(), start) == 0 && complaint.find("expected") != std::string::npos;
}

}  // namespace

TEST_CASE("Audacity labels are read as they are written") {
  const LabelFile file(
      "0.500000\t3.250000\tnormal rods=4 rock=granite rpm=1900 feed=92.5 percussion=160\r\n"
      "\\\t100.0\t2000.0\n"
      "\n"
      "4\t5.5\topen_rattling\n");
  const std::vector<analysis::Label> labels = read_labels(file.path());
  REQUIRE(labels.size() == 2);
  CHECK(labels[0].start_s == 0.5);
  CHECK(labels[0].end_s == 3.25);
  CHECK(labels[0].situation == Situation::kNormal);
  CHECK(labels[0].rods == 4);
  CHECK(labels[0].rock == "granite");
  CHECK(labels[0].rpm == 1900);
  CHECK(labels[0].feed_bar == 92.5);
  CHECK(labels[0].percussion_bar == 160);
  CHECK(labels[1].situation == Situation::kOpenRattling);
  CHECK(labels[1].rods == 0);
  CHECK(labels[1].feed_bar == 0);
  CHECK(labels[1].line == 4);
}

TEST_CASE("a byte order mark is no part of the first number") {
  const LabelFile file(
      "\xef\xbb\xbf"
      "0.5\t2\tnormal\n");
  CHECK(read_labels(file.path()).at(0).start_s == 0.5);
}

TEST_CASE("a value out of its range is told with the range and its unit") {
  const auto ends_in = [](const char* text, const std::string& end) {
    const std::string complaint = LabelFile(text).complaint();
    INFO(complaint);
    return complaint.size() > end.size() &&
           complaint.compare(complaint.size() - end.size(), end.size(), end) == 0;
  };
  CHECK(ends_in("0\t1\tnormal rods=25\n", "rods: is 25, expected 1...20"));
  CHECK(ends_in("0\t1\tnormal rods=2.5\n", "rods: is 2.5, expected a whole number, 1...20"));
  CHECK(ends_in("0\t1\tnormal rpm=9000\n", "rpm: is 9000 r/min, expected 1...4000 r/min"));
  CHECK(ends_in("0\t1\tnormal feed=301\n", "feed: is 301 bar, expected 1...300 bar"));
  CHECK(ends_in("0\t1\tnormal percussion=0\n", "percussion: is 0 bar, expected 1...300 bar"));
  CHECK(ends_in("-1\t1\tnormal\n", "start: is -1 s, expected 0...1000000 s"));
  CHECK(ends_in("0\t1\tnormal feed=much\n", "feed: 'much' is no number, expected 1...300 bar"));
}

TEST_CASE("every mistake is told with its line and key") {
  CHECK(complains("0\t1\tnormal\n1\t2\tnormall\n", 2, "situation"));
  CHECK(complains("0\t1\t\n", 1, "situation"));
  CHECK(complains("0\t1\tnormal rods=2 rods=3\n", 1, "rods"));
  CHECK(complains("0\t1\tnormal rods=0\n", 1, "rods"));
  CHECK(complains("0\t1\tnormal rods=2.5\n", 1, "rods"));
  CHECK(complains("0\t1\tnormal rod=2\n", 1, "rod"));
  CHECK(complains("0\t1\tnormal rpm=fast\n", 1, "rpm"));
  CHECK(complains("0\t1\tnormal feed=0\n", 1, "feed"));
  CHECK(complains("0\t1\tnormal feed=301\n", 1, "feed"));
  CHECK(complains("0\t1\tnormal percussion=high\n", 1, "percussion"));
  CHECK(complains("0\t1\tnormal rock=\n", 1, "rock"));
  CHECK(complains("0\t1\tnormal rock=../x\n", 1, "rock"));
  CHECK(complains("\n3\t2\tnormal\n", 2, "end"));
  CHECK(complains("3\t3\tnormal\n", 1, "end"));
  CHECK(complains("-1\t3\tnormal\n", 1, "start"));
  CHECK(complains("nan\t3\tnormal\n", 1, "start"));
  CHECK(complains("0 1 normal\n", 1, "label"));
  CHECK(LabelFile("").complaint().find("holds no labels") != std::string::npos);
}
