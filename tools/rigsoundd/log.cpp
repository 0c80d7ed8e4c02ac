#include "log.hpp"

#include <spdlog/async.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/sinks/systemd_sink.h>
#include <spdlog/spdlog.h>

#include <cstdlib>
#include <memory>

namespace rigsound::daemon {
namespace {

constexpr std::size_t kQueue = 1024;

spdlog::sink_ptr make_sink() {
  if (std::getenv("JOURNAL_STREAM") != nullptr)
    return std::make_shared<spdlog::sinks::systemd_sink_mt>("rigsoundd");
  return std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
}

}  // namespace

void start_log() {
  spdlog::init_thread_pool(kQueue, 1);
  auto logger = std::make_shared<spdlog::async_logger>("rigsoundd", make_sink(), spdlog::thread_pool(),
                                                       spdlog::async_overflow_policy::overrun_oldest);
  logger->flush_on(spdlog::level::info);
  spdlog::set_default_logger(logger);
  spdlog::set_pattern("%Y-%m-%d %H:%M:%S.%e %^%l%$: %v");
}

void stop_log() { spdlog::shutdown(); }

// As one argument a text is no format: braces in it stay.
void log_info(const std::string& text) { spdlog::info(text); }

void log_warning(const std::string& text) { spdlog::warn(text); }

void log_error(const std::string& text) { spdlog::error(text); }

std::uint64_t lost_log_entries() {
  const auto pool = spdlog::thread_pool();
  return pool ? pool->overrun_counter() : 0;
}

}  // namespace rigsound::daemon
