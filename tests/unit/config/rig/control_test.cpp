// [control]: who may reach the socket, the loopback port and the metrics, and the token's file.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "config/rig/rig_texts.hpp"

using namespace rigsound;
using namespace rigsound::test;
namespace fs = std::filesystem;

namespace {

std::string control_refusal(const std::string& keys) { return refusal("[control]\n" + keys); }

const std::string kTokenFile = "token_file = \"token\"\n";

/// What is read, or said behind the name of the file, of a token's file with this content.
std::string token_of(const std::string& text, fs::perms others = fs::perms::none) {
  const TemporaryFolder folder;
  config::Rig rig;
  const fs::path file = folder.write("token", text);
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write | others);
  rig.control.token_file = file.string();
  std::string token;
  const std::string said = complaint([&] { token = config::control_token(rig); });
  return said.empty() ? token : said.substr(file.string().size());
}

}  // namespace

TEST_CASE("control over tcp is for addresses of this machine, written in digits") {
  for (const char* good : {"127.0.0.1:7", "127.9.8.7:7", "[::1]:7"})
    CHECK(control_refusal("tcp = \"" + std::string(good) + "\"\n" + kTokenFile).empty());
  for (const char* wrong : {"localhost:7", "10.0.0.1:7", "0.0.0.0:7", "[::]:7", "[::2]:7", "127.0.0.0/8:7",
                            "127.0.0.1", "128.0.0.1:7", "127.0.0.1:0", "7", ":7"})
    CHECK(control_refusal("tcp = \"" + std::string(wrong) + "\"\n" + kTokenFile) ==
          ":2: control.tcp: \"" + std::string(wrong) +
              "\" is no address on this machine, expected 127.0.0.1:PORT, [::1]:PORT or \"\"");
}

TEST_CASE("tcp and its token go together") {
  CHECK(control_refusal("tcp = \"127.0.0.1:7\"\n") ==
        ":2: control.tcp: lets every user of this machine in, expected token_file too");
  CHECK(control_refusal(kTokenFile) ==
        ":2: control.token_file: is asked for over tcp only, expected tcp too");
  CHECK(control_refusal("tcp = \"\"\ntoken_file = \"\"\n").empty());
  const TemporaryFolder folder;
  const config::Rig rig = config::load_rig(
      folder.write("rigs/rig.toml", "[control]\ntcp = \"127.0.0.1:7\"\ntoken_file = \"../secret\"\n"));
  CHECK(rig.control.token_file == (folder.path / "secret").string());  // from the rig's folder
}

TEST_CASE("metrics are at an address with a port, or nowhere") {
  for (const char* good : {"", "127.0.0.1:9", "0.0.0.0:9", "localhost:9", "[::]:9"})
    CHECK(control_refusal("metrics = \"" + std::string(good) + "\"\n").empty());
  for (const char* wrong : {"9", "localhost", "localhost:0", "localhost:65536"})
    CHECK(control_refusal("metrics = \"" + std::string(wrong) + "\"\n") ==
          ":2: control.metrics: \"" + std::string(wrong) +
              "\" is no address with a port, expected HOST:PORT or \"\"");
}

TEST_CASE("a token is one line of 16 to 512 letters without blanks, quotes and backslashes") {
  const std::string shortest(16, 'a'), longest(512, '~');
  CHECK(token_of(shortest) == shortest);
  CHECK(token_of(shortest + "\n") == shortest);
  CHECK(token_of(shortest + "\r\nmore\n") == shortest);
  CHECK(token_of(longest) == longest);
  CHECK(token_of("!#[]^0123456789Az") == "!#[]^0123456789Az");
  const std::string rule =
      ":1: is no token, expected 16...512 letters and digits without blanks, such as `openssl rand -hex 32` "
      "makes";
  for (const std::string& wrong : {std::string(), std::string(15, 'a'), std::string(513, 'a'), shortest + " ",
                                   " " + shortest, shortest + "\"", shortest + "\\", shortest + "\x7f",
                                   shortest + "\xc3\xa4", shortest + "\t", "\n" + shortest}) {
    CAPTURE(wrong);
    CHECK(token_of(wrong) == rule);
  }
}

TEST_CASE("a token that every user may read, and one that is not there, are refused") {
  const std::string token(20, 'a');
  for (const fs::perms others : {fs::perms::others_read, fs::perms::others_write, fs::perms::others_exec})
    CHECK(token_of(token, others) == ": is open to every user, expected a token for few (chmod o= FILE)");
  CHECK(token_of(token, fs::perms::group_read) == token);
  config::Rig rig;
  CHECK(config::control_token(rig).empty());
  const TemporaryFolder folder;
  for (const fs::path& none : {folder.path / "nothing", folder.path}) {
    rig.control.token_file = none.string();
    CHECK(complaint([&] { config::control_token(rig); }) ==
          none.string() + ": cannot be read, expected the token of [control] tcp");
  }
}
