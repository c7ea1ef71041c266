#pragma once

#include "app/tuning/what_if_report.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/latest_task.h"
#include "app/workbench/workbench.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QPushButton;
class QStackedWidget;

namespace halbench::widgets {
class EmptyState;
class FigureView;
struct Remark;
class VerdictView;
} // namespace halbench::widgets

namespace halbench::app {

/// A move of any recording, and what the gains that are proposed would have made of it: what `analyse
/// --what-if` answers, with its refusals and its words (resources/help/tuning.md, "What if"). Reads, judges
/// and replays on threads of its own. Thread: GUI.
class WhatIfPage : public QWidget {
    Q_OBJECT
public:
    explicit WhatIfPage(Workbench& bench, QWidget* parent = nullptr);

    /// `ranFile`: the gains that ran, where they are not recorded; else empty. `conditions`: of the board, as
    /// far as the recording does not say them.
    void use(const QString& recording, const QString& ranFile, const LoopConditions& conditions);
    void forget();
    bool isUsed() const { return m_ran.has_value(); }

    /// The gains that are proposed; nothing: none. While a hand moves them the curve follows, its band comes
    /// when it rests.
    void propose(const std::optional<LoopLaw>& law, bool isMoving);

    widgets::FigureView& picture() { return *m_picture; }

Q_SIGNALS:
    void recordingWanted();              ///< whoever has files asks for one and calls use()
    void used(const QString& recording); ///< it is read and can be shown
    void refused(const Error& error);    ///< it is none to replay

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void take(Result<RanMove> ran);
    void judge();
    void predict();
    void spread();
    bool isOfRan() const;
    QWidget* buildAnswer();
    void refreshWords();
    void draw();
    void showVerdict();
    std::vector<widgets::Remark> remarks() const;

    Workbench& m_bench;
    FileQueue m_files;
    LatestTask m_judging;    ///< whether the identified loop explains it
    LatestTask m_predicting; ///< with the proposed gains
    LatestTask m_spreading;  ///< and its band
    int m_asked = 0;         ///< recordings; only the last one counts
    QString m_path;
    std::optional<RanMove> m_ran;
    std::optional<Error> m_unjudged;             ///< why nothing can be judged
    std::shared_ptr<const WhatIfBasis> m_record; ///< nothing: not judged yet
    std::optional<LoopLaw> m_law;
    std::optional<Result<WhatIf>> m_predicted; ///< with that law
    std::optional<WhatIf> m_spread;            ///< likewise, with its band
    bool m_isMoving = false;
    bool m_isWaiting = false; ///< for the answer to an older law

    QStackedWidget* m_pages = nullptr; ///< empty, answer
    widgets::EmptyState* m_empty = nullptr;
    QPushButton* m_other = nullptr;
    QPushButton* m_remove = nullptr;
    widgets::VerdictView* m_verdict = nullptr;
    widgets::FigureView* m_picture = nullptr;
};

/// Why a what-if says what it says: figures beside those of the recorded motion, and every finding.
std::vector<widgets::Remark> whatIfRemarks(const RecordedMove& move, const Result<WhatIf>& whatIf,
                                           const std::optional<WhatIf>& spread, const DisplayUnits& units);

} // namespace halbench::app
