// Makes one system call fail, as a full disk does: preloaded, FAULT names the call (write, fsync, rename, mkdir) and
// FAULT_AT which of them, counted from 1. A write that fails writes half of what it was given first. Once failed, all
// later ones of the kind fail too, as they do on a disk that is full; standard output and error are left alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int fails(const char* call) {
  static long count = 0;
  const char *wanted = getenv("FAULT"), *at = getenv("FAULT_AT");
  if (!wanted || !at || strcmp(wanted, call) != 0) return 0;
  return ++count >= atol(at);
}

ssize_t write(int descriptor, const void* bytes, size_t length) {
  static ssize_t (*next)(int, const void*, size_t) = 0;
  if (!next) next = (ssize_t(*)(int, const void*, size_t))dlsym(RTLD_NEXT, "write");
  if (descriptor <= 2 || !fails("write")) return next(descriptor, bytes, length);
  static int half = 0;
  if (!half++ && length > 1) return next(descriptor, bytes, length / 2);
  errno = ENOSPC;
  return -1;
}

int fsync(int descriptor) {
  static int (*next)(int) = 0;
  if (!next) next = (int (*)(int))dlsym(RTLD_NEXT, "fsync");
  if (!fails("fsync")) return next(descriptor);
  errno = EIO;
  return -1;
}

int rename(const char* from, const char* to) {
  static int (*next)(const char*, const char*) = 0;
  if (!next) next = (int (*)(const char*, const char*))dlsym(RTLD_NEXT, "rename");
  if (!fails("rename")) return next(from, to);
  errno = ENOSPC;
  return -1;
}

int mkdir(const char* path, mode_t mode) {
  static int (*next)(const char*, mode_t) = 0;
  if (!next) next = (int (*)(const char*, mode_t))dlsym(RTLD_NEXT, "mkdir");
  if (!fails("mkdir")) return next(path, mode);
  errno = ENOSPC;
  return -1;
}
