// Preloaded into a program: the N-th call of a kind on a file below a folder fails, as a disk that is full or
// broken lets it. RIGSOUND_FAULT is `FOLDER KIND N`, KIND one of open, read, write, fsync, rename; N = 0 lets
// all pass. With RIGSOUND_FAULT_HANGS it does not fail but never returns, as on a disk that does not answer.
// How many calls of the kind there were is written to RIGSOUND_FAULT_COUNT at the end.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

struct Plan {
  std::string folder, kind;
  long chosen = 0;

  Plan() {
    const char* const text = std::getenv("RIGSOUND_FAULT");
    char name[PATH_MAX] = {}, of[16] = {};
    if (text == nullptr || std::sscanf(text, "%4095s %15s %ld", name, of, &chosen) != 3) return;
    folder = name;
    kind = of;
  }
};

const Plan& plan() {
  static const Plan* const plan = new Plan;  // calls come until the very end
  return *plan;
}

std::atomic<long> calls{0};

struct Report {
  ~Report() {
    const char* const file = std::getenv("RIGSOUND_FAULT_COUNT");
    if (file == nullptr) return;
    std::FILE* const out = std::fopen(file, "w");
    if (out == nullptr) return;
    std::fprintf(out, "%ld\n", calls.load());
    std::fclose(out);
  }
} report;

/// Whether this call is the one; sets errno.
bool fails(const char* kind, const char* path, int error) {
  const Plan& p = plan();
  if (p.folder.empty() || p.kind != kind || std::strncmp(path, p.folder.c_str(), p.folder.size()) != 0)
    return false;
  if (++calls != p.chosen) return false;
  while (std::getenv("RIGSOUND_FAULT_HANGS") != nullptr) ::pause();
  errno = error;
  return true;
}

bool fails(const char* kind, int fd, int error) {
  if (plan().kind != kind) return false;
  char path[PATH_MAX] = {};
  const std::string link = "/proc/self/fd/" + std::to_string(fd);
  return ::readlink(link.c_str(), path, sizeof path - 1) > 0 && fails(kind, path, error);
}

std::string absolute(const char* path) {
  if (path[0] == '/') return path;
  char here[PATH_MAX] = {};
  return ::getcwd(here, sizeof here) == nullptr ? path : std::string(here) + "/" + path;
}

int error_of_open(int flags) { return (flags & O_CREAT) != 0 ? ENOSPC : EIO; }

template <class Function>
Function real(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

mode_t mode_of(int flags, va_list list) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? static_cast<mode_t>(va_arg(list, int)) : 0;
}

}  // namespace

#define RIGSOUND_OPEN(name)                                                     \
  int name(const char* path, int flags, ...) {                                  \
    va_list list;                                                               \
    va_start(list, flags);                                                      \
    const mode_t mode = mode_of(flags, list);                                   \
    va_end(list);                                                               \
    if (fails("open", absolute(path).c_str(), error_of_open(flags))) return -1; \
    return real<int (*)(const char*, int, ...)>(#name)(path, flags, mode);      \
  }

#define RIGSOUND_MAKE(name)                                          \
  int name(char* pattern, int flags) {                               \
    if (fails("open", absolute(pattern).c_str(), ENOSPC)) return -1; \
    return real<int (*)(char*, int)>(#name)(pattern, flags);         \
  }

#define RIGSOUND_MAKE_SUFFIX(name)                                        \
  int name(char* pattern, int length, int flags) {                        \
    if (fails("open", absolute(pattern).c_str(), ENOSPC)) return -1;      \
    return real<int (*)(char*, int, int)>(#name)(pattern, length, flags); \
  }

extern "C" {

RIGSOUND_OPEN(open)
RIGSOUND_OPEN(open64)
RIGSOUND_MAKE(mkostemp)
RIGSOUND_MAKE_SUFFIX(mkostemps)

int mkstemps(char* pattern, int length) {
  if (fails("open", absolute(pattern).c_str(), ENOSPC)) return -1;
  return real<int (*)(char*, int)>("mkstemps")(pattern, length);
}

char* mkdtemp(char* pattern) {
  if (fails("open", absolute(pattern).c_str(), ENOSPC)) return nullptr;
  return real<char* (*)(char*)>("mkdtemp")(pattern);
}

std::FILE* fopen(const char* path, const char* mode) {
  if (fails("open", absolute(path).c_str(), mode[0] == 'r' ? EIO : ENOSPC)) return nullptr;
  return real<std::FILE* (*)(const char*, const char*)>("fopen")(path, mode);
}

std::FILE* fopen64(const char* path, const char* mode) {
  if (fails("open", absolute(path).c_str(), mode[0] == 'r' ? EIO : ENOSPC)) return nullptr;
  return real<std::FILE* (*)(const char*, const char*)>("fopen64")(path, mode);
}

ssize_t read(int fd, void* bytes, size_t size) {
  return fails("read", fd, EIO) ? -1 : real<ssize_t (*)(int, void*, size_t)>("read")(fd, bytes, size);
}

ssize_t write(int fd, const void* bytes, size_t size) {
  return fails("write", fd, ENOSPC) ? -1
                                    : real<ssize_t (*)(int, const void*, size_t)>("write")(fd, bytes, size);
}

ssize_t writev(int fd, const iovec* pieces, int count) {
  return fails("write", fd, ENOSPC) ? -1
                                    : real<ssize_t (*)(int, const iovec*, int)>("writev")(fd, pieces, count);
}

int fsync(int fd) { return fails("fsync", fd, EIO) ? -1 : real<int (*)(int)>("fsync")(fd); }

int rename(const char* from, const char* to) {
  return fails("rename", absolute(to).c_str(), EIO)
             ? -1
             : real<int (*)(const char*, const char*)>("rename")(from, to);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
  if (fails("rename", absolute(to).c_str(), EIO)) return -1;
  return real<int (*)(int, const char*, int, const char*, unsigned)>("renameat2")(from_folder, from,
                                                                                  to_folder, to, flags);
}
}
