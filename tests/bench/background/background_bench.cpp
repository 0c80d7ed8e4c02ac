// The engine behind the drill in the figures of its table: what is wanted and what was reached.
//   background_bench [--data FOLDER]     recordings: FOLDER/engine, FOLDER/notes
// FOLDER defaults to $RIGSOUND_TEST_DATA. Ends with 1 when a row misses its bound.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "background/table.hpp"

int main(int argc, char** argv) {
  std::filesystem::path data;
  if (const char* folder = std::getenv("RIGSOUND_TEST_DATA")) data = folder;
  if (argc == 3 && std::strcmp(argv[1], "--data") == 0) {
    data = argv[2];
  } else if (argc != 1) {
    std::fprintf(stderr, "usage: %s [--data FOLDER]\n", argv[0]);
    return 2;
  }
  rigsound::bench::Table table;
  rigsound::bench::transform_rows(table);
  rigsound::bench::recording_rows(table, data);
  rigsound::bench::note_rows(table, data);
  rigsound::bench::simulator_rows(table);
  rigsound::bench::blow_rows(table);
  rigsound::bench::run_time_rows(table);
  return table.held() ? 0 : 1;
}
