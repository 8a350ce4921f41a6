#include "instrument_worker.hpp"

namespace pmts::app {

using instrument::GeodimeterDriver;

Ticket InstrumentDesk::listMemory() {
    return request([](GeodimeterDriver& station, std::stop_token stop) { return station.listMemory(std::move(stop)); },
                   [](InstrumentDesk& desk, Ticket ticket, const instrument::MemoryListing& listing) {
                       Q_EMIT desk.memoryListed(ticket, listing);
                   });
}

Ticket InstrumentDesk::downloadFile(const instrument::MemoryFileId& file) {
    return request(
        [worker = worker_.get(), file, ticket = last_ticket_ + 1](GeodimeterDriver& station, std::stop_token stop) {
            return station.download(file, worker->transferOf(ticket), std::move(stop));
        },
        [](InstrumentDesk& desk, Ticket ticket, const instrument::DownloadedFile& downloaded) {
            Q_EMIT desk.fileDownloaded(ticket, downloaded);
        });
}

Ticket InstrumentDesk::uploadFile(const instrument::MemoryFileId& file, const std::vector<std::string>& lines) {
    return request(
        [worker = worker_.get(), file, lines, ticket = last_ticket_ + 1](GeodimeterDriver& station,
                                                                         std::stop_token stop) {
            return station.upload(file, lines, worker->transferOf(ticket), std::move(stop));
        },
        [](InstrumentDesk& desk, Ticket ticket, const instrument::UploadedFile& uploaded) {
            Q_EMIT desk.fileUploaded(ticket, uploaded);
        });
}

Ticket InstrumentDesk::backUpLabels() {
    return request(
        [worker = worker_.get(), ticket = last_ticket_ + 1](GeodimeterDriver& station, std::stop_token stop) {
            return station.backUpLabels(worker->transferOf(ticket), std::move(stop));
        },
        [](InstrumentDesk& desk, Ticket ticket, const protocol::LabelBackup& backup) {
            Q_EMIT desk.labelsBackedUp(ticket, backup);
        });
}

Ticket InstrumentDesk::calibrateCompensator() {
    return request(
        [worker = worker_.get(), ticket = last_ticket_ + 1](GeodimeterDriver& station, std::stop_token stop) {
            return station.calibrateCompensator([worker, ticket] { return worker->question(ticket); }, std::move(stop));
        },
        [](InstrumentDesk& desk, Ticket ticket, const instrument::CompensatorRun& run) {
            Q_EMIT desk.compensatorCalibrated(ticket, run);
        });
}

void InstrumentDesk::answerInstrument(bool yes) {
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get(), yes] { worker->answerInstrument(yes); }, Qt::QueuedConnection);
}

void InstrumentDesk::setTargetTest(const instrument::TargetTest& test) {
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get(), test] { worker->setTargetTest(test); }, Qt::QueuedConnection);
}

instrument::OnTransfer InstrumentDesk::Worker::transferOf(Ticket ticket) {
    return [self = weak_from_this(), ticket](const instrument::TransferProgress& progress) {
        if (const auto worker = self.lock()) {
            worker->say([ticket, progress](InstrumentDesk& desk) { Q_EMIT desk.transferProgressed(ticket, progress); });
        }
    };
}

core::Completion<bool> InstrumentDesk::Worker::question(Ticket ticket) {
    question_.emplace();
    say([ticket](InstrumentDesk& desk) { Q_EMIT desk.instrumentAsks(ticket); });
    return *question_;
}

void InstrumentDesk::Worker::answerInstrument(bool yes) {
    if (const auto question = std::exchange(question_, std::nullopt)) {
        question->complete(yes);
    }
}

void InstrumentDesk::Worker::setTargetTest(const instrument::TargetTest& test) {
    target_test_ = test;
    if (connection_) {
        connection_->station().setTargetTest(test);
    }
}

}  // namespace pmts::app
