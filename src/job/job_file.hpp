#pragma once

#include "gdal_session.hpp"
#include "job_lock.hpp"

namespace pmts::job {

/// A job file opened for writing, with the right to do so. The dataset closes before the lock goes.
struct JobFile {
    JobLock lock;
    Dataset dataset;
};

/// Builds the file under a temporary name and renames it: a job file is complete or absent.
[[nodiscard]] core::Result<JobFile> createJobFile(const QString& path);

/// Looks at the file without changing it, refuses what is no job, damaged, newer or in use, then opens,
/// migrates and repairs it.
[[nodiscard]] core::Result<JobFile> openJobFile(const QString& path);

}  // namespace pmts::job
