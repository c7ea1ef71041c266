#include "app/workspaces/tune/what_if_page.h"

#include "app/figures/tuning_figures.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "app/procedures/tune/tune.h"
#include "app/workbench/display_quantity.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/parts/picture_scroll.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/verdict_view.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

using widgets::Remark;
using widgets::VerdictLevel;

WhatIfPage::WhatIfPage(Workbench& bench, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_pages(new QStackedWidget(this)),
      m_empty(new widgets::EmptyState(m_pages)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_pages);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(buildAnswer());
    connect(m_empty, &widgets::EmptyState::actionTriggered, this, &WhatIfPage::recordingWanted);
    connect(m_other, &QPushButton::clicked, this, &WhatIfPage::recordingWanted);
    connect(m_remove, &QPushButton::clicked, this, &WhatIfPage::forget);
    connect(&m_bench, &Workbench::identificationChanged, this, &WhatIfPage::judge);
    connect(&m_bench, &Workbench::displayUnitsChanged, this, &WhatIfPage::draw);
    refreshWords();
}

QWidget* WhatIfPage::buildAnswer() {
    auto* page = new QWidget(m_pages);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::GridStep_px);
    auto* row = new QHBoxLayout;
    m_other = new QPushButton(page);
    m_remove = new QPushButton(page);
    row->addWidget(m_other);
    row->addWidget(m_remove);
    row->addStretch(1);
    m_verdict = new widgets::VerdictView(page);
    m_verdict->setObjectName(QStringLiteral("whatIf"));
    auto* scroll = new PictureScroll(*m_verdict, page);
    m_picture = &scroll->picture();
    column->addLayout(row);
    column->addWidget(m_verdict);
    column->addWidget(scroll, 1);
    return page;
}

void WhatIfPage::refreshWords() {
    m_empty->setWords(tr("No recording selected"),
                      tr("What-if: replay a recorded move with the proposed gains. Needs an identified motor "
                         "that matches the recording."),
                      tr("Open a recorded move"));
    m_other->setText(tr("Another move\u2026"));
    m_other->setToolTip(tr("Choose another recording"));
    m_remove->setText(tr("Remove"));
    m_remove->setToolTip(tr("Clear this page; the recording is kept"));
    draw();
}

void WhatIfPage::use(const QString& recording, const QString& ranFile, const LoopConditions& conditions) {
    const int number = ++m_asked;
    m_files.run([recording = recording.toStdString(), ranFile = ranFile.toStdString(),
                 conditions] { return readRanMove(recording, ranFile, conditions); },
                [this, number, recording](Result<RanMove> ran) {
                    if (number != m_asked) {
                        return; // another one was chosen meanwhile
                    }
                    m_path = ran ? recording : m_path;
                    take(std::move(ran));
                });
}

/// What is shown stays when the next one is none.
void WhatIfPage::take(Result<RanMove> ran) {
    if (!ran) {
        Q_EMIT refused(ran.error());
        return;
    }
    m_ran = *std::move(ran);
    judge();
    Q_EMIT used(m_path);
}

void WhatIfPage::forget() {
    ++m_asked;
    m_ran.reset();
    m_path.clear();
    judge();
}

void WhatIfPage::judge() {
    m_judging.cancel();
    m_record.reset();
    m_unjudged.reset();
    const auto& identification = m_bench.identification();
    if (m_ran && identification) {
        const TuneConfig defaults;
        const WhatIfConfig config{m_ran->move, m_ran->law, m_ran->conditions, motorEstimate(*identification),
                                  UncertaintyDraws{defaults.draws, defaults.seed}};
        m_judging.run([config] { return prepareWhatIf(config); },
                      [this](Result<WhatIfBasis> basis) {
                          if (basis) {
                              m_record = std::make_shared<const WhatIfBasis>(*std::move(basis));
                          } else {
                              m_unjudged = basis.error();
                          }
                          predict();
                      });
    }
    predict();
}

void WhatIfPage::propose(const std::optional<LoopLaw>& law, bool isMoving) {
    m_law = law;
    m_isMoving = isMoving;
    predict();
}

/// The gains that ran have the record itself.
bool WhatIfPage::isOfRan() const {
    return m_law && m_record &&
           isSameLaw(*m_law, m_record->config.ran, m_record->config.conditions.timing.period_s);
}

/// Each answer is seen before the next is asked for, so that the curve follows however long its move is.
/// Nobody pays for it while it is not seen.
void WhatIfPage::predict() {
    m_spreading.cancel();
    m_spread.reset();
    if (m_predicting.isBusy() && m_record && m_law) {
        m_isWaiting = true;
        return;
    }
    m_isWaiting = false;
    m_predicting.cancel();
    if (!isVisible() || !m_record || !m_law || isOfRan()) {
        m_predicted.reset();
        draw();
        return;
    }
    m_predicting.run([record = m_record, law = *m_law] { return whatIf(*record, law); },
                     [this](const Result<WhatIf>& answer) {
                         m_predicted = answer;
                         if (m_isWaiting) {
                             predict();
                         }
                         draw();
                         spread();
                     });
}

void WhatIfPage::spread() {
    if (m_isMoving || m_predicting.isBusy() || !m_predicted || !*m_predicted || !m_record || !m_law) {
        return;
    }
    m_spreading.run([record = m_record, law = *m_law] { return whatIfWithBand(*record, law); },
                    [this](const Result<WhatIf>& answer) {
                        if (answer && m_predicted) {
                            m_spread = *answer;
                            draw();
                        }
                    });
}

void WhatIfPage::draw() {
    m_pages->setCurrentIndex(m_ran ? 1 : 0);
    if (m_ran) {
        const widgets::AngleUnit unit = m_bench.displayUnits().angle;
        widgets::Figure figure = recordedMoveFigure(m_ran->move, unit);
        if (m_predicted && *m_predicted) {
            addWhatIfCurves(figure, **m_predicted, m_spread ? m_spread->band : std::nullopt,
                            m_ran->move.reference_rad, unit);
        }
        m_picture->setFigure(std::move(figure));
    } else {
        m_picture->setFigure({});
    }
    showVerdict();
}

void WhatIfPage::showVerdict() {
    const QString name = QFileInfo(m_path).fileName();
    const bool isWithheld = m_record && m_record->quality.verdict == Verdict::Refused;
    if (!m_ran) {
        m_verdict->setVerdict(VerdictLevel::Doubtful, {}, {});
    } else if (m_unjudged || isWithheld || (m_predicted && !*m_predicted)) {
        m_verdict->setVerdict(VerdictLevel::Refused, tr("%1: no prediction for the proposed gains").arg(name),
                              remarks());
    } else if (!m_record) {
        m_verdict->setVerdict(VerdictLevel::Doubtful,
                              m_bench.identification() ? tr("Assessing %1").arg(name)
                                                       : tr("%1: identify the motor first").arg(name),
                              {});
    } else {
        const auto& quality = m_spread ? m_spread->quality : m_record->quality;
        m_verdict->setVerdict(quality.verdict == Verdict::Good ? VerdictLevel::Good : VerdictLevel::Doubtful,
                              quality.verdict == Verdict::Good
                                  ? tr("%1: the identified model matches the recorded move").arg(name)
                                  : tr("%1: doubtful, see below").arg(name),
                              remarks());
    }
}

std::vector<Remark> WhatIfPage::remarks() const {
    if (m_unjudged) {
        return {{widgets::inWords(m_unjudged->message), widgets::inWords(m_unjudged->hint)}};
    }
    std::vector<Remark> result;
    result.push_back({tr("%1 % of the recorded motion are outside the band of the recorded gains.")
                          .arg(widgets::numberText(100.0 * m_record->outside_ratio, 2)),
                      {}});
    if (m_predicted) {
        const auto more = whatIfRemarks(m_ran->move, *m_predicted, m_spread, m_bench.displayUnits());
        result.insert(result.end(), more.begin(), more.end());
        return result;
    }
    if (isOfRan()) {
        result.push_back(
            {tr("The proposed gains equal the recorded gains: the recording shows their result."), {}});
    }
    for (const Finding& finding : m_record->quality.findings) {
        result.push_back({widgets::inWords(finding.message), widgets::inWords(finding.hint)});
    }
    return result;
}

void WhatIfPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    predict(); // the gains may be others by now
}

void WhatIfPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

namespace {

/// The words of this file for the translator, outside of the page.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::WhatIfWords)
};

} // namespace

std::vector<Remark> whatIfRemarks(const RecordedMove& move, const Result<WhatIf>& whatIf,
                                  const std::optional<WhatIf>& spread, const DisplayUnits& units) {
    if (!whatIf) {
        return {{Words::tr("No prediction for the proposed gains: %1")
                     .arg(widgets::inWords(whatIf.error().message)),
                 widgets::inWords(whatIf.error().hint)}};
    }
    std::vector<Remark> remarks;
    const MotionFigures would = motionFigures(move.reference_rad, whatIf->angle_rad);
    const MotionFigures was = motionFigures(move.reference_rad, move.position_rad);
    if (would.overshoot_rad && was.overshoot_rad) {
        remarks.push_back(
            {Words::tr("With the proposed gains: overshoot %1 instead of %2, final error %3 instead of %4.")
                 .arg(angleText(*would.overshoot_rad, units), angleText(*was.overshoot_rad, units),
                      angleText(std::abs(would.finalError_rad), units),
                      angleText(std::abs(was.finalError_rad), units)),
             {}});
    }
    for (const Finding& finding : (spread ? *spread : *whatIf).quality.findings) {
        remarks.push_back({widgets::inWords(finding.message), widgets::inWords(finding.hint)});
    }
    return remarks;
}

} // namespace halbench::app
