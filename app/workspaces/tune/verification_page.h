#pragma once

#include "app/procedures/apply/apply_procedure.h"
#include "app/procedures/move/what_if.h"
#include "app/workbench/latest_task.h"
#include "app/workbench/workbench.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>


namespace halbench::widgets {
struct Figure;
struct Remark;
class FigureView;
class VerdictView;
} // namespace halbench::widgets

namespace halbench::app {

class TuneSession;

/// Verification move of applied gains: measured over predicted, with the verdict of their agreement, and a
/// replay of the move with the gains that are proposed now. Workers judge and replay. Thread: GUI.
class VerificationPage : public QWidget {
    Q_OBJECT
public:
    /// `session` outlives it.
    VerificationPage(Workbench& bench, TuneSession& session, QWidget* parent = nullptr);

    /// Expects the move of these gains, which are being applied; forgets the one before.
    void expect(const LoopLaw& law);
    /// Shows the move that was expected. One of another motor or device is not: it was forgotten.
    void showMove(const ApplyResult& result);
    /// Neither verdict nor picture holds any longer, nor those of a move that is still running.
    void forget();
    /// The gains of the move were taken back.
    void setUndone();
    /// The move as a record to replay; nothing: none, or not judged yet.
    std::shared_ptr<const WhatIfBasis> record() const { return m_record; }
    /// Computes the band of the replay with the proposed gains, unless they are moving.
    void replay();
    /// Other gains are asked for.
    void cancelReplay();
    void draw();
    void drawIfVisible(); ///< showing the page draws it
    widgets::FigureView& picture() { return *m_picture; }

Q_SIGNALS:
    void shown();
    void forgotten();
    void recordReady(); ///< the proposed gains can be asked for with it

protected:
    void showEvent(QShowEvent* event) override;

private:
    void prepareRecord();
    void forgetRecord();
    bool isReplayDrawn() const;
    void addReplay(widgets::Figure& figure, std::vector<widgets::Remark>& remarks) const;
    void showAgreement(const std::vector<widgets::Remark>& remarks);

    Workbench& m_bench;
    TuneSession& m_session;
    std::optional<LoopLaw> m_law; ///< of the move
    std::optional<ApplyResult> m_verified;
    bool m_isUndone = false;
    std::shared_ptr<const WhatIfBasis> m_record;
    std::optional<WhatIf> m_replayed; ///< with its band
    LatestTask m_recalling;           ///< whether the identified loop explains the move
    LatestTask m_replaying;
    widgets::VerdictView* m_agreement; ///< of measured and predicted
    widgets::FigureView* m_picture = nullptr;
};

} // namespace halbench::app
