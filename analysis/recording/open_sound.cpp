#include "recording/open_sound.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <utility>

namespace rigsound::analysis {
namespace {

OpenSound::Repaired& repaired(void* user) { return *static_cast<OpenSound::Repaired*>(user); }

sf_count_t header_length(const OpenSound::Repaired& r) {
  return static_cast<sf_count_t>(r.repair.header.size());
}

sf_count_t repaired_length(void* user) {
  const OpenSound::Repaired& r = repaired(user);
  return header_length(r) + r.repair.end - r.repair.begin;
}

sf_count_t repaired_seek(sf_count_t offset, int whence, void* user) {
  OpenSound::Repaired& r = repaired(user);
  const sf_count_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? r.at : repaired_length(user);
  r.at = std::clamp<sf_count_t>(from + offset, 0, repaired_length(user));
  return r.at;
}

sf_count_t repaired_tell(void* user) { return repaired(user).at; }

sf_count_t repaired_read(void* to, sf_count_t count, void* user) {
  OpenSound::Repaired& r = repaired(user);
  const sf_count_t head = std::clamp<sf_count_t>(header_length(r) - r.at, 0, count);
  std::memcpy(to, r.repair.header.data() + std::min(r.at, header_length(r)), static_cast<std::size_t>(head));
  r.at += head;
  const sf_count_t wanted = std::min(count - head, repaired_length(user) - r.at);
  r.file.clear();
  r.file.seekg(r.repair.begin + r.at - header_length(r));
  r.file.read(static_cast<char*>(to) + head, wanted);
  r.at += r.file.gcount();
  return head + r.file.gcount();
}

sf_count_t repaired_write(const void*, sf_count_t, void*) { return 0; }

}  // namespace

OpenSound::OpenSound(const std::filesystem::path& path, SF_INFO& info) : sound_(nullptr, &sf_close) {
  std::optional<WaveRepair> repair = wave_repair(path);
  if (!repair) {
    sound_.reset(sf_open(path.c_str(), SFM_READ, &info));
    return;
  }
  repaired_.repair = std::move(*repair);
  repaired_.file.open(path, std::ios::binary);
  SF_VIRTUAL_IO io{repaired_length, repaired_seek, repaired_read, repaired_write, repaired_tell};
  sound_.reset(sf_open_virtual(&io, SFM_READ, &info, &repaired_));
}

}  // namespace rigsound::analysis
