#pragma once

#include "pmts/core/result.hpp"

#include <QString>

namespace pmts::job {

/// The right to write one job file: an advisory lock of the operating system on `<job>.lock` beside it. It
/// dies with the process, so nothing stale is left to clear away after a crash. Move only.
class JobLock {
public:
    /// kFile when another PMTS has the job open, or when the folder cannot be written.
    [[nodiscard]] static core::Result<JobLock> take(const QString& job_path);

    JobLock(JobLock&& other) noexcept;
    JobLock& operator=(JobLock&& other) noexcept;
    ~JobLock();

private:
    JobLock(int descriptor, QString path) : descriptor_(descriptor), path_(std::move(path)) {}

    int descriptor_ = -1;
    QString path_;
};

}  // namespace pmts::job
