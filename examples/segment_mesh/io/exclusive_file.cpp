// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/exclusive_file.h"

#include <cerrno>
#include <system_error>

#if defined(__unix__) || defined(__APPLE__)
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace segment_mesh {

namespace fs = std::filesystem;

namespace {

std::system_error last_error()
{
  return std::system_error(errno, std::generic_category());
}

#if defined(__unix__) || defined(__APPLE__)

/// Whether a path still leads to an open file.
bool is_at(const fs::path& path, int descriptor)
{
  struct stat file, entry;
  return fstat(descriptor, &file) == 0 && lstat(path.c_str(), &entry) == 0 &&
         file.st_dev == entry.st_dev && file.st_ino == entry.st_ino;
}

bool is_file(const fs::path& path)
{
  struct stat entry;
  return lstat(path.c_str(), &entry) == 0 && S_ISREG(entry.st_mode);
}

/// Some file systems cannot do it for some kinds of files, and say so.
void sync(int descriptor)
{
  if (fsync(descriptor) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS)
    throw last_error();
}

#endif

} // namespace

#if defined(__unix__) || defined(__APPLE__)

std::FILE* open_exclusively(const fs::path& path, const fs::path& target)
{
  const mode_t mode = is_file(target) ? 0600 : 0666;
  const int descriptor =
    open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
  if (descriptor < 0 && errno == EEXIST)
    return nullptr;
  if (descriptor < 0)
    throw last_error();
  // Before it is locked, another run can take it for one that was left behind.
  const bool is_taken = flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (is_taken || !is_at(path, descriptor)) {
    unlink(path.c_str());
    close(descriptor);
    return nullptr;
  }
  std::FILE* const file = fdopen(descriptor, "wb");
  if (file == nullptr) {
    const std::system_error error = last_error();
    unlink(path.c_str());
    close(descriptor);
    throw error;
  }
  return file;
}

void copy_permissions(const fs::path& target, std::FILE* file)
{
  struct stat entry;
  if (lstat(target.c_str(), &entry) == 0 && S_ISREG(entry.st_mode) &&
      fchmod(fileno(file), entry.st_mode & 0777) != 0)
    errno = 0; // a file system without permissions, or with those of its owner alone
}

void write_to_disk(std::FILE* file)
{
  if (std::fflush(file) != 0)
    throw last_error();
  sync(fileno(file));
}

void write_folder_to_disk(const fs::path& folder)
{
  const int descriptor =
    open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
    return;
  try {
    sync(descriptor);
  } catch (...) {
    close(descriptor);
    throw;
  }
  close(descriptor);
}

void remove_if_left_behind(const fs::path& path)
{
  struct stat entry;
  if (lstat(path.c_str(), &entry) != 0 || !S_ISREG(entry.st_mode) || entry.st_uid != geteuid())
    return;
  const int descriptor = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0)
    return;
  // Whoever has the lock renames the file before it lets go of it.
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 && is_at(path, descriptor))
    unlink(path.c_str());
  close(descriptor);
}

#else

std::FILE* open_exclusively(const fs::path& path, const fs::path&)
{
  std::FILE* const file = std::fopen(path.string().c_str(), "wbx");
  if (file == nullptr && errno != EEXIST)
    throw last_error();
  return file;
}

void copy_permissions(const fs::path&, std::FILE*) {}

void write_to_disk(std::FILE* file)
{
  if (std::fflush(file) != 0)
    throw last_error();
}

void write_folder_to_disk(const fs::path&) {}

void remove_if_left_behind(const fs::path&) {}

#endif

} // namespace segment_mesh
