// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Temporary_file.h"

#include <fstream>
#include <mutex>
#include <set>
#include <system_error>

#if defined(__unix__) || defined(__APPLE__)
#include <csignal>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace segment_mesh {

namespace fs = std::filesystem;

namespace {

/// All files that are there now. A file comes, goes and gets its name under the mutex, so that a
/// signal finds each either listed or not there. Never destroyed: a signal may come late.
struct Registry
{
  std::mutex mutex;
  std::set<fs::path> paths;
};

Registry& registry()
{
  static Registry& instance = *new Registry;
  return instance;
}

std::system_error last_error()
{
  return std::system_error(errno, std::generic_category());
}

#if defined(__unix__) || defined(__APPLE__)

/// Whether a path still leads to an open file.
bool is_at(const fs::path& path, int descriptor)
{
  struct stat file, entry;
  return fstat(descriptor, &file) == 0 && stat(path.c_str(), &entry) == 0 &&
         file.st_dev == entry.st_dev && file.st_ino == entry.st_ino;
}

/// Whoever has the lock may remove or rename the file before it lets go of the lock. So a lock counts
/// only if the path leads to the locked file after it was taken.
int open_locked(const fs::path& path)
{
  for (;;) {
    const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0)
      throw last_error();
    const bool has_failed = flock(descriptor, LOCK_EX | LOCK_NB) != 0;
    const std::system_error error = last_error();
    if (has_failed && Temporary_file::is_locked(error.code())) {
      close(descriptor);
      throw error;
    }
    if (has_failed || is_at(path, descriptor))
      return descriptor;
    close(descriptor);
  }
}

void close_locked(int descriptor)
{
  close(descriptor);
}

sigset_t signals_that_end()
{
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action;
    if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN)
      sigaddset(&set, signal);
  }
  return set;
}

/// Waits for a signal; then nobody gets past the mutex any more.
void end_on_signal(sigset_t set)
{
  int signal = 0;
  if (sigwait(&set, &signal) != 0)
    return;
  registry().mutex.lock();
  for (const fs::path& path : registry().paths)
    unlink(path.c_str());
  std::signal(signal, SIG_DFL);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  raise(signal);
}

#else

int open_locked(const fs::path& path)
{
  if (!std::ofstream(path))
    throw last_error();
  return -1;
}

void close_locked(int) {}

#endif

} // namespace

Temporary_file::Temporary_file(fs::path path) : m_path(std::move(path))
{
  const std::lock_guard<std::mutex> lock(registry().mutex);
  m_descriptor = open_locked(m_path);
  registry().paths.insert(m_path);
}

Temporary_file::~Temporary_file()
{
  const std::lock_guard<std::mutex> lock(registry().mutex);
  if (registry().paths.erase(m_path) > 0) {
    std::error_code ignored;
    fs::remove(m_path, ignored);
  }
  close_locked(m_descriptor);
}

void Temporary_file::rename_to(const fs::path& target)
{
  const std::lock_guard<std::mutex> lock(registry().mutex);
  fs::rename(m_path, target);
  registry().paths.erase(m_path);
}

bool Temporary_file::is_locked(const std::error_code& error)
{
  return error == std::errc::operation_would_block;
}

void Temporary_file::remove_all_on_signals()
{
#if defined(__unix__) || defined(__APPLE__)
  const sigset_t set = signals_that_end();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  std::thread(end_on_signal, set).detach();
#endif
}

} // namespace segment_mesh
