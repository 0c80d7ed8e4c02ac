#include "rigsound/log/udp_capture_writer.hpp"

#include "log/capture_dump.hpp"

namespace rigsound::log {

UdpCaptureWriter::UdpCaptureWriter(const std::filesystem::path& file)
    : file_(std::make_unique<CaptureDump>(file)) {}

UdpCaptureWriter::~UdpCaptureWriter() = default;

void UdpCaptureWriter::write(std::int64_t time_ns, int port, const std::string& text) {
  file_->write(time_ns, udp_packet(text, {}, {MadeUpEnd().address, port}));
}

void UdpCaptureWriter::flush() { file_->flush(); }

}  // namespace rigsound::log
