// What libc calls do when they meet a virtual camera. Everything else goes on to libc.
#include "camera_file.hpp"
#include "virtual_device.hpp"

#include <cerrno>
#include <cstdarg>
#include <dlfcn.h>
#include <fcntl.h>
#include <map>
#include <memory>
#include <mutex>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace pmts::virtual_v4l2 {
namespace {

/// Never destroyed: programs close descriptors until their very end.
struct Registry {
    std::mutex mutex;
    std::map<int, std::shared_ptr<VirtualDevice>> devices;

    static Registry& instance() {
        static auto* const registry = new Registry;
        return *registry;
    }
    std::shared_ptr<VirtualDevice> find(int fd) {
        const std::lock_guard lock(mutex);
        const auto found = devices.find(fd);
        return found == devices.end() ? nullptr : found->second;
    }
    std::shared_ptr<VirtualDevice> remove(int fd) {
        const std::lock_guard lock(mutex);
        const auto node = devices.extract(fd);
        return node.empty() ? nullptr : node.mapped();
    }
};

template <class Function>
Function libc(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

int refuse(int error_number) {
    errno = error_number;
    return -1;
}

/// Programs that write a camera's file mean the file itself.
bool opensCamera(const char* path, int flags) {
    return (flags & O_ACCMODE) == O_RDWR && (flags & O_CREAT) == 0 && isCameraPath(path);
}

int openCamera(const char* path, int flags) {
    const auto file = readCameraFile(path);
    if (!file) {
        return refuse(ENOENT);
    }
    if (file->busy || file->forbidden) {
        return refuse(file->busy ? EBUSY : EACCES);
    }
    const int fd = ::eventfd(0, EFD_SEMAPHORE | EFD_NONBLOCK | EFD_CLOEXEC);
    if (fd < 0) {
        return -1;
    }
    Registry& registry = Registry::instance();
    const std::lock_guard lock(registry.mutex);
    registry.devices[fd] = std::make_shared<VirtualDevice>(path, fd, (flags & O_NONBLOCK) != 0);
    return fd;
}

using Open = int (*)(const char*, int, ...);

int openEither(const char* libc_name, const char* path, int flags, mode_t mode) {
    return opensCamera(path, flags) ? openCamera(path, flags) : libc<Open>(libc_name)(path, flags, mode);
}

mode_t modeOf(int flags, va_list arguments) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

void* mapEither(const char* libc_name, void* address, size_t length, int protection, int flags, int fd,
                off_t offset) {
    using Map = void* (*)(void*, size_t, int, int, int, off_t);
    static const Map next = libc<Map>(libc_name);
    const auto device = fd >= 0 ? Registry::instance().find(fd) : nullptr;
    return next(address, length, protection, flags, device ? device->memoryFd() : fd, offset);
}

}  // namespace
}  // namespace pmts::virtual_v4l2

using namespace pmts::virtual_v4l2;

extern "C" {

int open(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = modeOf(flags, arguments);
    va_end(arguments);
    return openEither("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = modeOf(flags, arguments);
    va_end(arguments);
    return openEither("open64", path, flags, mode);
}

int __open_2(const char* path, int flags) { return openEither("open", path, flags, 0); }
int __open64_2(const char* path, int flags) { return openEither("open64", path, flags, 0); }

int close(int fd) {
    static const auto next = libc<int (*)(int)>("close");
    const auto device =
        Registry::instance().remove(fd);  // its thread ends before the descriptor is free again
    if (device) {
        unsigned long off = 0;
        (void)device->control(VIDIOC_STREAMOFF, &off);
    }
    return next(fd);
}

int ioctl(int fd, unsigned long request, ...) noexcept {
    va_list arguments;
    va_start(arguments, request);
    void* const argument = va_arg(arguments, void*);
    va_end(arguments);
    if (const auto device = Registry::instance().find(fd)) {
        const int failure = device->control(request & 0xffffffffUL, argument);
        return failure == 0 ? 0 : refuse(failure);
    }
    static const auto next = libc<int (*)(int, unsigned long, ...)>("ioctl");
    return next(fd, request, argument);
}

void* mmap(void* address, size_t length, int protection, int flags, int fd, off_t offset) noexcept {
    return mapEither("mmap", address, length, protection, flags, fd, offset);
}

void* mmap64(void* address, size_t length, int protection, int flags, int fd, off64_t offset) noexcept {
    return mapEither("mmap64", address, length, protection, flags, fd, offset);
}
}
