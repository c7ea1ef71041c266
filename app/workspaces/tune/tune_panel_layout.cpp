// What the Tune panel is made of, and its words.
#include "app/procedures/apply/live_apply_procedure.h"
#include "app/workbench/document_files.h"
#include "app/workspaces/parts/foreign_motor_notice.h"
#include "app/workspaces/parts/page_chooser.h"
#include "app/workspaces/parts/preflight.h"
#include "app/workspaces/tune/design_table.h"
#include "app/workspaces/tune/loop/filter_editor.h"
#include "app/workspaces/tune/loop/gain_editor.h"
#include "app/workspaces/tune/loop/loop_sliders.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "app/workspaces/tune/loop/tune_form.h"
#include "app/workspaces/tune/tune_numbers.h"
#include "app/workspaces/tune/tune_panel.h"
#include "app/workspaces/tune/what_if_page.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/progress_row.h"
#include "widgets/controls/verdict_view.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {
namespace {

QScrollArea* scrolled(QWidget* page) {
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus); // it follows the focus of its controls
    scroll->setWidget(page);
    return scroll;
}

void say(QAbstractButton& button, const QString& text, const QString& help) {
    button.setText(text);
    button.setToolTip(help);
    button.setAccessibleName(text);
}

} // namespace

QWidget* TunePanel::buildSettings() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, widgets::PanelMargin_px, 0);
    column->setSpacing(widgets::GroupSpacing_px);
    m_model = new QLabel(page);
    m_model->setWordWrap(true);
    m_form = new TuneForm(page);
    m_gains = new GainEditor(page);
    m_filters = new FilterEditor(page);
    m_sliders = new LoopSliders(page);
    m_verdict = new widgets::VerdictView(page);
    m_verdict->setObjectName(QStringLiteral("design"));
    m_preflight = new Preflight(m_bench, page);
    m_foreign = new ForeignMotorNotice(m_bench, page);
    m_progress = new widgets::ProgressRow(page);
    m_progress->hide();
    m_inSteps = new QCheckBox;
    m_outlook = new QLabel(page);
    m_outlook->setWordWrap(true);
    for (QWidget* part : std::initializer_list<QWidget*>{m_model, m_sliders, m_form, m_gains, m_filters}) {
        column->addWidget(part);
    }
    m_verdict->moveRemarks(*column); // its title stays in sight
    column->addWidget(m_preflight);
    column->addWidget(m_foreign);
    column->addStretch(1);
    auto* settings = new QWidget;
    auto* all = new QVBoxLayout(settings);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(widgets::PanelMargin_px);
    all->addWidget(scrolled(page), 1);
    all->addWidget(m_verdict);
    all->addWidget(m_inSteps, 0, Qt::AlignLeft);
    all->addWidget(m_outlook);
    all->addWidget(m_progress); // what is decided stays in sight, however far the rest is scrolled
    all->addWidget(buildButtons());
    return settings;
}

QWidget* TunePanel::buildButtons() {
    auto* bar = new QWidget;
    auto* grid = new QGridLayout(bar);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(widgets::PanelMargin_px);
    m_apply = new QPushButton(bar);
    m_keep = new QPushButton(bar);
    m_restore = new QPushButton(bar);
    m_save = new QToolButton(bar); // icons: the words of three do not fit the settings' width
    m_open = new QToolButton(bar);
    widgets::setRole(*m_apply, widgets::Role::Primary);
    m_restore->setIcon(widgets::themedIcon(QStringLiteral("revert")));
    m_save->setIcon(widgets::themedIcon(QStringLiteral("save")));
    m_open->setIcon(widgets::themedIcon(QStringLiteral("open")));
    grid->addWidget(m_apply, 0, 0);
    grid->addWidget(m_save, 0, 1);
    grid->addWidget(m_open, 0, 2);
    grid->addWidget(m_keep, 1, 0);
    grid->addWidget(m_restore, 1, 1, 1, 3, Qt::AlignLeft);
    grid->setColumnStretch(3, 1);
    m_save->hide();
    m_open->hide();
    return bar;
}

QWidget* TunePanel::buildFigures() {
    m_figures = new PageChooser;
    m_loop = new LoopView(m_figures);
    m_measure = new QPushButton(m_loop);
    m_measure->hide();
    m_loop->addTool(*m_measure);
    m_large = new widgets::FigureView(m_figures);
    m_linear = new widgets::FigureView(m_figures);
    m_loaded = new widgets::FigureView(m_figures);
    m_numbers = new TuneNumbers(m_figures);
    m_table = new DesignTable(m_figures);
    m_verificationPage = buildVerification();
    m_whatIfPage = new WhatIfPage(m_bench, m_figures);
    for (QWidget* page : std::initializer_list<QWidget*>{m_loop, m_large, m_linear, m_loaded, m_numbers,
                                                         m_table, m_verificationPage, m_whatIfPage}) {
        m_figures->addPage(page);
    }
    constexpr int CharactersOfAPicture = 52; // less squeezes its axes
    m_figures->pairWhenWide(m_loop, m_large, 2 * CharactersOfAPicture * fontMetrics().averageCharWidth());
    m_figures->setPageEnabled(m_verificationPage, false);
    for (widgets::FigureView* view :
         {&m_loop->picture(), m_large, m_linear, m_loaded, m_verification, &m_whatIfPage->picture()}) {
        connect(view, &widgets::FigureView::exportRequested, this, [this, view] {
            savePicture(this, m_chooser, QStringLiteral("tuning.svg"), m_files, *view,
                        [this](const Error& error) { showError(error); });
        });
    }
    return m_figures;
}

QWidget* TunePanel::buildVerification() {
    auto* page = new QWidget(m_figures);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::GridStep_px);
    m_agreement = new widgets::VerdictView(page);
    m_agreement->setObjectName(QStringLiteral("agreement"));
    m_verification = new widgets::FigureView;
    m_verification->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored); // growVerification() says
    auto* content = new QWidget;
    auto* below = new QVBoxLayout(content);
    below->setContentsMargins(0, 0, 0, 0);
    below->setSpacing(widgets::GridStep_px);
    below->addWidget(m_verification, 1);
    m_agreement->moveRemarks(*below);
    column->addWidget(m_agreement);
    m_verificationRoom = scrolled(content);
    m_verificationRoom->viewport()->installEventFilter(this);
    column->addWidget(m_verificationRoom, 1); // three plots want more height than a small screen has
    return page;
}

/// Why there is nothing to tune, with the way out.
void TunePanel::refreshEmpty() {
    const DeviceSession& session = m_bench.session();
    const std::size_t axes = session.catalogue().axes.size();
    const bool isOther =
        session.state() == SessionState::Connected && axes > 0 && !session.catalogue().hasProcedure("tune");
    if (isOther) {
        m_empty->setWords(tr("Tuning is not available for this device"),
                          tr("%n control loop(s), no identification procedure. Edit the gains in Parameters "
                             "and check them with a reference in Drive.",
                             nullptr, static_cast<int>(axes)));
    } else if (session.state() == SessionState::Connected && axes > 1) {
        m_empty->setWords(tr("No axes to tune yet"),
                          tr("Gains are designed for identified axes and verified by a step of each axis "
                             "before they are kept."),
                          tr("Identify the axes"));
    } else {
        m_empty->setWords(
            tr("No motor to tune"),
            tr("Gains are designed for an identified motor and verified by a move before they are kept."),
            tr("Identify the motor"));
    }
}

void TunePanel::refreshWords() {
    const DisplayUnits& units = m_bench.displayUnits();
    refreshEmpty();
    m_empty->setIconName(QStringLiteral("settings"));
    say(*m_apply, tr("Apply and verify"),
        tr("Write all gains together, then verify with a step; Esc stops it"));
    m_inSteps->setText(tr("Apply gradually"));
    m_inSteps->setToolTip(
        tr("Change K_P and K_P + K_D/T by at most half in each step. Each step is assessed before writing "
           "and verified by a move; on failure the previous gains are restored"));
    m_inSteps->setAccessibleName(m_inSteps->text());
    say(*m_keep, tr("Keep"),
        tr("New gains active until power-off (simulated: until disconnect). To keep them: Save to device, in "
           "the Parameters panel"));
    say(*m_restore, tr("Restore"), tr("Restore the previous gains"));
    say(*m_save, tr("Save gains\u2026"), tr("Save gains to a file"));
    say(*m_open, tr("Open gains\u2026"),
        tr("Use the gains of a file as proposed gains; they are assessed before they can be applied"));
    refreshOutlook();
    refreshMeasuredWords();
    refreshHistory();
    m_figures->setTitle(m_loop, tr("Open loop"), tr("Bode, Nyquist and Nichols plot, and sensitivity"));
    m_figures->setTitle(m_large, tr("Step of %1").arg(angleText(LargeStep_rad, units)),
                        tr("A large step with friction and current limit"));
    m_figures->setTitle(m_linear, tr("Small step"), tr("Step of the linear loop"));
    m_figures->setTitle(m_loaded, tr("Disturbance"), tr("Effect of a load step on the angle"));
    m_figures->setTitle(m_numbers, tr("Numbers"), tr("All predicted figures, margins with intervals"));
    m_figures->setTitle(m_table, tr("Designs"), tr("Saved designs, compared with the proposed gains"));
    m_figures->setTitle(m_verificationPage, tr("Verification"),
                        tr("Measured move and prediction, after Apply and verify"));
    m_figures->setTitle(m_whatIfPage, tr("What-if"), tr("Replay of a recorded move with the proposed gains"));
    m_figures->setAccessibleName(tr("Predictions"));
    drawVerification();
    refreshModel();
}

/// The picture is the answer: it has all of the page, and what is said of it begins at the lower edge.
void TunePanel::growVerification() {
    const int words_px = 2 * fontMetrics().lineSpacing() + 2 * widgets::GridStep_px;
    m_verification->setMinimumHeight(std::max(0, m_verificationRoom->viewport()->height() - words_px));
}

/// From what the procedure is given: how far and how long is said before it is pressed, not in a tooltip.
void TunePanel::refreshOutlook() {
    if (const auto reason = obstacle()) {
        m_outlook->setToolTip(widgets::inWords(reason->hint));
        m_outlook->setText(tr("These gains cannot be applied: %1. %2.")
                               .arg(widgets::inWords(reason->message), widgets::inWords(reason->hint)));
        return;
    }
    m_outlook->setToolTip(tr("Relative to the start position of the rotor"));
    const devices::Catalogue& catalogue = m_bench.session().catalogue();
    const DisplayUnits& units = m_bench.displayUnits();
    m_outlook->setText(m_inSteps->isChecked()
                           ? liveStepWords(liveStepOutlook({}, catalogue), units)
                           : verificationWords(verificationOutlook(stepVerification({}), catalogue), units));
}

void TunePanel::onUnits() {
    m_gains->setAngleUnit(m_bench.displayUnits().angle);
    m_loop->setFrequencyUnit(m_bench.displayUnits().frequency);
    m_filters->setFrequencyUnit(m_bench.displayUnits().frequency);
    refreshWords(); // and every picture with them
}

} // namespace halbench::app
