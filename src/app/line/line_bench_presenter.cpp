#include "pmts/app/line/line_bench_presenter.hpp"

#include "pmts/protocol/seen_routine.hpp"

#include <QDir>
#include <QFileInfo>
#include <QPromise>
#include <QThreadPool>

#include <cmath>

namespace pmts::app {
namespace {

constexpr int kProgressSteps = 1000;
const QString kTopic = QStringLiteral("line bench");
const QString kDoubtful = QStringLiteral("[?");  ///< typed in the search: whatever is not sure

QString inFolder(const QString& folder, const char* name) { return QDir(folder).filePath(QLatin1String(name)); }

}  // namespace

LineBenchPresenter::LineBenchPresenter(MessageCentre& messages, const QString& data_folder, Threading threading,
                                       QObject* parent)
    : QObject(parent),
      messages_(messages),
      data_folder_(data_folder),
      threading_(threading),
      names_(inFolder(data_folder, "variable-names.json")) {
    if (const auto loaded = names_.load(); !loaded) {
        messages_.report(loaded.error(), MessageAction::kNone, kTopic);
    }
    connect(&watcher_, &QFutureWatcherBase::finished, this, &LineBenchPresenter::finish);
    connect(&watcher_, &QFutureWatcherBase::progressValueChanged, this,
            [this](int value) { Q_EMIT progressed(static_cast<double>(value) / kProgressSteps); });
}

LineBenchPresenter::~LineBenchPresenter() {
    watcher_.disconnect(this);
    watcher_.cancel();
    watcher_.waitForFinished();
}

void LineBenchPresenter::run(const QString& reason, Work work) {
    if (isBusy()) {
        messages_.toast(tr("Wait until this is done, or cancel it: %1").arg(reason_));
        return;
    }
    reason_ = reason;
    has_failed_ = false;
    const auto promise = std::make_shared<QPromise<Apply>>();
    promise->setProgressRange(0, kProgressSteps);
    watcher_.setFuture(promise->future());
    promise->start();
    Q_EMIT busyChanged();
    const auto job = [promise, work = std::move(work)] {
        promise->addResult(work([&promise](double share) {
            promise->setProgressValue(static_cast<int>(std::lround(share * kProgressSteps)));
            return !promise->isCanceled();
        }));
        promise->finish();
    };
    if (threading_ == Threading::kOwnThread) {
        QThreadPool::globalInstance()->start(job);
    } else {
        job();
    }
}

void LineBenchPresenter::finish() {
    reason_.clear();
    if (watcher_.isCanceled() || watcher_.future().resultCount() == 0) {
        messages_.toast(tr("Cancelled: what was shown before stays."));
    } else {
        watcher_.result()();
    }
    Q_EMIT busyChanged();
}

void LineBenchPresenter::cancel() { watcher_.cancel(); }

DeviceState LineBenchPresenter::state() const {
    if (isBusy()) {
        return DeviceState::kBusy;
    }
    if (has_failed_) {
        return DeviceState::kFailed;
    }
    if (!findings_) {
        return DeviceState::kIdle;
    }
    return findings_->unsure > 0 || findings_->characters.empty() ? DeviceState::kWarning : DeviceState::kGood;
}

void LineBenchPresenter::import(const QString& path) { importAs(path, {}, {}); }

void LineBenchPresenter::importAs(const QString& path, std::optional<protocol::CaptureFormat> format,
                                  std::optional<double> samples_per_s) {
    if (!isBusy()) {
        path_ = path;  // before the work: a format that was told wrongly is corrected after it failed
    }
    run(tr("Reading %1").arg(QFileInfo(path).fileName()),
        [this, path, format, samples_per_s](const protocol::Progress& progress) -> Apply {
            auto recording = readLineRecording(path, format, samples_per_s, progress);
            auto found = recording ? examined(std::move(*recording), progress)
                                   : core::Result<LineFindings>(tl::unexpected(recording.error()));
            auto read = found ? decoded(std::move(*found), {}, progress) : std::move(found);
            const auto outcome = std::make_shared<core::Result<LineFindings>>(std::move(read));
            return [this, outcome] {
                if (*outcome) {
                    choices_.clear();
                    matches_.clear();
                    match_sentence_.clear();
                    search_sentence_.clear();
                    search_at_ = 0;
                }
                take(std::move(*outcome));
            };
        });
}

void LineBenchPresenter::importAgain(std::optional<protocol::CaptureFormat> format, const QString& rate) {
    const auto samples_per_s = sampleRateFrom(rate);
    if (!samples_per_s && !rate.trimmed().isEmpty()) {
        messages_.toast(tr("Type samples a second, such as 1 MHz."));
        return;
    }
    if (!path_.isEmpty()) {
        importAs(path_, format, samples_per_s);
    }
}

void LineBenchPresenter::decodeAgain() {
    if (!findings_ || !findings_->recording->hasLevels()) {
        return;
    }
    run(tr("Decoding"), [this, before = findings_, choices = choices_](const protocol::Progress& progress) -> Apply {
        LineFindings fresh{.recording = before->recording, .signal = before->signal, .lines = before->lines,
                           .port = before->port, .repeats = before->repeats, .characters = {}, .talk = {}, .bytes = {},
                           .doubt_marks = {}, .values = {}, .variables = {}};
        const auto outcome = std::make_shared<core::Result<LineFindings>>(decoded(std::move(fresh), choices, progress));
        return [this, outcome] { take(std::move(*outcome)); };
    });
}

void LineBenchPresenter::take(core::Result<LineFindings> findings) {
    if (!findings) {
        return fail(findings.error());
    }
    messages_.solve(kTopic);
    findings_ = std::make_shared<const LineFindings>(std::move(*findings));
    talk_.setFindings(findings_);
    Q_EMIT changed();
    Q_EMIT matchesChanged();
}

void LineBenchPresenter::fail(const core::Error& error) {
    has_failed_ = error.kind != core::ErrorKind::kCancelled;
    messages_.report(error, MessageAction::kNone, kTopic);
}

void LineBenchPresenter::setDecoded(int line, bool decoded) {
    choices_[line].is_decoded = decoded;
    decodeAgain();
}

void LineBenchPresenter::setFraming(int line, const protocol::Framing& framing) {
    choices_[line].framing = framing;
    choices_[line].is_decoded = true;
    decodeAgain();
}

void LineBenchPresenter::useFound(int line, std::size_t place) {
    const auto found = findings_ ? std::ranges::find(findings_->lines, line, [](const FoundLine& l) { return l.activity.line; })
                                 : std::vector<FoundLine>::const_iterator();
    if (findings_ && found != findings_->lines.end() && place < found->scores.size()) {
        setFraming(line, found->scores[place].framing);
    }
}

void LineBenchPresenter::setSide(int line, protocol::TalkSide side) {
    choices_[line].side = side;
    decodeAgain();
}

void LineBenchPresenter::correlate(const QString& panel_text) {
    if (!findings_) {
        return;
    }
    run(tr("Comparing with the panel"), [this, panel_text, findings = findings_](const protocol::Progress&) -> Apply {
        const auto matches = protocol::correlated(panel_text, findings->values);
        return [this, panel_text, findings, matches] {
            matches_ = matches ? *matches : std::vector<protocol::PanelMatch>();
            match_sentence_ = !matches            ? matches.error().sentence()
                              : matches_.empty() ? tr("None of %1 values fits %2.").arg(findings->values.size()).arg(panel_text)
                                                 : tr("Candidates for %1, best first: %2.").arg(panel_text).arg(matches_.size());
            Q_EMIT matchesChanged();
        };
    });
}

void LineBenchPresenter::nameVariable(const QString& variable, const QString& name) {
    if (const auto kept = names_.set(variable, name); !kept) {
        messages_.report(kept.error(), MessageAction::kNone, kTopic);
    }
    Q_EMIT changed();
    Q_EMIT matchesChanged();
}

/// Where the next or previous place begins, round the end; npos: nowhere. `find(from)` and `rfind(from)` look from there.
template <class Find, class RFind>
std::size_t LineBenchPresenter::placeFrom(bool forward, Find find, RFind rfind) {
    std::size_t at = std::string::npos;
    if (forward) {
        at = find(search_at_);
    } else if (search_at_ > 1) {
        at = rfind(search_at_ - 2);  // before the one that is shown
    }
    const bool round = at == std::string::npos;
    if (round) {
        at = forward ? find(0) : rfind(std::string::npos);
    }
    search_sentence_ = round && search_at_ > 0 ? tr("Round the end.") : QString();
    return at;
}

void LineBenchPresenter::search(const QString& typed, bool forward) {
    if (!findings_) {
        return;
    }
    const auto wanted = protocol::searchedBytes(typed.toLatin1().toStdString());
    if (!wanted) {
        search_sentence_ = wanted.error().sentence();
        return Q_EMIT searched(-1);
    }
    const std::string& marked = typed == kDoubtful ? findings_->doubt_marks : findings_->bytes;
    const std::string pattern = typed == kDoubtful ? std::string("?") : *wanted;
    const std::size_t at = placeFrom(
        forward, [&](std::size_t from) { return marked.find(pattern, from); },
        [&](std::size_t from) { return marked.rfind(pattern, from); });
    if (at == std::string::npos) {
        search_sentence_ = tr("“%1” is nowhere.").arg(typed);
        return Q_EMIT searched(-1);
    }
    search_at_ = at + 1;
    Q_EMIT searched(static_cast<qsizetype>(at));
}

}  // namespace pmts::app
