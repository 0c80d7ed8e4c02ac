// Who may speak to the daemon, and when a subscriber is told.
#include "control_conversation.hpp"

#include <doctest/doctest.h>

#include "daemon/scraped.hpp"

using namespace rigsound;
using namespace rigsound::daemon;
using test::Scraped;

namespace {

constexpr const char* kMute = R"({"command":"mute","on":true})";

bool is_good(const std::string& answer) { return answer.rfind("{\"ok\":true", 0) == 0; }

}  // namespace

TEST_CASE("without a token anybody may speak") {
  Scraped daemon;
  ControlConversation talk(daemon);
  CHECK(is_good(talk.answer(kMute)));
  CHECK_FALSE(talk.over());
}

TEST_CASE("with a token it comes first, and opens the conversation for good") {
  Scraped daemon;
  ControlConversation talk(daemon, "s3cret");
  CHECK(talk.answer(R"({"token":"s3cret"})") == "{\"ok\":true}\n");
  CHECK_FALSE(talk.over());
  CHECK(is_good(talk.answer(kMute)));
  CHECK_FALSE(is_good(talk.answer(R"({"token":"s3cret"})")));  // no command
  CHECK_FALSE(talk.over());
}

TEST_CASE("anything but the token ends the conversation") {
  for (const char* said :
       {R"({"token":"S3cret"})", R"({"token":"s3cre"})", R"({"token":"s3cret "})", R"({"token":""})",
        R"({"token":7})", R"({"token":null})", R"({"token":"s3cret","command":"mute"})",
        R"({"Token":"s3cret"})", R"(["s3cret"])", R"("s3cret")", "s3cret", "", "{}", kMute}) {
    CAPTURE(std::string(said));
    Scraped daemon;
    ControlConversation talk(daemon, "s3cret");
    CHECK(talk.answer(said).rfind("{\"ok\":false,\"error\":\"expected {", 0) == 0);
    CHECK(talk.over());
  }
}

TEST_CASE("news come to a subscriber only, when they are due, and cover what it was too slow for") {
  Scraped daemon;
  ControlConversation talk(daemon);
  CHECK(talk.news(0).empty());
  CHECK_FALSE(talk.wants_news());
  talk.news_not_taken(0);
  CHECK(is_good(talk.answer(R"({"command":"subscribe","every_s":1})")));
  CHECK(talk.wants_news());
  CHECK(talk.news(10).find("\"event\":\"change\"") != std::string::npos);
  CHECK(talk.news(11.5).empty());  // nothing has changed
  talk.news_not_taken(12);         // not yet due
  talk.news_not_taken(13);
  CHECK(talk.news(13.5).empty());
  daemon.reloads = 1;
  CHECK(talk.news(14).find("\"missed\":1,") != std::string::npos);
  CHECK(is_good(talk.answer(R"({"command":"unsubscribe"})")));
  CHECK_FALSE(talk.wants_news());
  CHECK(talk.news(100).empty());
}
