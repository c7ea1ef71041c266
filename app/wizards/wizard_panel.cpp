#include "app/wizards/wizard_panel.h"

#include "app/documents/result_header.h"
#include "app/documents/text/numbers.h"
#include "app/workbench/departure_text.h"
#include "app/workbench/document_files.h"
#include "app/workspaces/device/pace_row.h"
#include "widgets/controls/floating_rows.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/step_list.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace halbench::app {

WizardPanel::WizardPanel(Workbench& bench, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_steps(new widgets::StepList(this)),
      m_message(new widgets::MessageBar(this)), m_pages(new QStackedWidget(this)) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    m_own = new QWidget(this);
    outer->addWidget(m_own, 1);
    auto* row = new QHBoxLayout(m_own);
    row->setContentsMargins(widgets::PanelMargin_px, widgets::PanelMargin_px, widgets::PanelMargin_px,
                            widgets::PanelMargin_px);
    row->setSpacing(2 * widgets::GroupSpacing_px);
    // The procedure goes through the steps, not the user: the list only tells.
    m_steps->setFocusPolicy(Qt::NoFocus);
    m_steps->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_steps->setFrameShape(QFrame::NoFrame);
    row->addWidget(m_steps);
    row->addWidget(m_pages, 1);
    (new widgets::FloatingRows(*m_pages, Qt::TopEdge, m_own))->addRow(*m_message);
}

void WizardPanel::setAlternative(QWidget& other) {
    m_alternative = &other;
    layout()->addWidget(m_alternative);
    m_alternative->hide();
}

void WizardPanel::showAlternative(bool isShown) {
    m_own->setVisible(!isShown);
    if (m_alternative != nullptr) {
        m_alternative->setVisible(isShown);
    }
}

void WizardPanel::setFileChooser(FileChooser chooser) {
    m_chooser = std::move(chooser);
    onFileChooser();
}

QVBoxLayout* WizardPanel::columnOf(QWidget* page, int spacing_px) {
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(spacing_px);
    return column;
}

void WizardPanel::addPage(QWidget* page, bool isScrolled, QWidget* footer) {
    QWidget* shown = page;
    if (isScrolled) {
        auto* scroll = new QScrollArea(m_pages);
        scroll->setWidgetResizable(true);
        scroll->setFrameShape(QFrame::NoFrame);
        scroll->setFocusPolicy(Qt::NoFocus); // it follows the focus of its controls
        scroll->setWidget(page);
        shown = scroll;
    }
    if (footer != nullptr) {
        auto* both = new QWidget(m_pages);
        QVBoxLayout* column = columnOf(both, widgets::PanelMargin_px);
        column->addWidget(shown, 1);
        column->addWidget(footer);
        shown = both;
    }
    m_pages->addWidget(shown);
}

QWidget* WizardPanel::makeStartRow(QPushButton& start, QPushButton* beside) {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(widgets::PanelMargin_px);
    widgets::setRole(start, widgets::Role::Primary);
    row->addWidget(&start);
    if (beside != nullptr) {
        row->addWidget(beside);
    }
    row->addSpacing(widgets::GroupSpacing_px);
    row->addWidget(new PaceRow(m_bench, PaceRow::Place::BesideStart, bar));
    row->addStretch(1);
    auto* shortcut = new QShortcut(QKeySequence(QStringLiteral("Ctrl+Return")), m_own);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, &start, &QPushButton::click);
    return bar;
}

QWidget* WizardPanel::makePreparation(QLabel& intro, QWidget& form, QLabel& outlook, QWidget& preflight) {
    constexpr int CharactersOfAForm = 64; // wider, its names stand far from its fields
    auto* page = new QWidget;
    auto* column = columnOf(page, widgets::GroupSpacing_px);
    intro.setWordWrap(true);
    outlook.setWordWrap(true);
    form.setMaximumWidth(CharactersOfAForm * page->fontMetrics().averageCharWidth());
    for (QWidget* part : std::initializer_list<QWidget*>{&intro, &form, &outlook, &preflight}) {
        column->addWidget(part);
    }
    column->addStretch(1);
    return page;
}

QWidget* WizardPanel::makeButtonRow(const std::vector<QPushButton*>& buttons) {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(widgets::PanelMargin_px);
    for (QPushButton* button : buttons) {
        row->addWidget(button);
    }
    row->addStretch(1);
    return bar;
}

void WizardPanel::beginAgain(int page, QPushButton& start) {
    showPage(page);
    resetSteps();
    start.setFocus(Qt::OtherFocusReason);
}

void WizardPanel::showPage(int page) {
    m_pages->setCurrentIndex(page);
}

void WizardPanel::setSteps(const QStringList& names) {
    std::vector<widgets::StepState> states;
    states.reserve(static_cast<std::size_t>(m_steps->count()));
    for (int step = 0; step < m_steps->count(); ++step) {
        states.push_back(m_steps->stepState(step));
    }
    m_steps->setSteps(names);
    for (int step = 0; step < m_steps->count(); ++step) {
        const auto index = static_cast<std::size_t>(step);
        endStep(step, index < states.size() ? states[index] : widgets::StepState::Waiting);
    }
}

void WizardPanel::runStep(int step) {
    for (int other = 0; other < m_steps->count(); ++other) {
        endStep(other, other < step    ? widgets::StepState::Done
                       : other == step ? widgets::StepState::Running
                                       : widgets::StepState::Waiting);
    }
    m_steps->setCurrentStep(step);
}

void WizardPanel::endStep(int step, widgets::StepState state) {
    m_steps->setStepState(step, state);
}

void WizardPanel::resetSteps() {
    for (int step = 0; step < m_steps->count(); ++step) {
        endStep(step, widgets::StepState::Waiting);
    }
    m_steps->setCurrentStep(-1);
}

bool WizardPanel::couldStart(bool hasStarted) {
    m_isMine = hasStarted;
    if (hasStarted) {
        m_bench.setCurrentDriven();
        m_message->clear();
    } else {
        m_message->showMessage({widgets::Severity::Error,
                                tr("Not started: no device connected, or the device is busy."),
                                tr("Connect a device, or wait until the running task ends."),
                                {}});
    }
    return hasStarted;
}

void WizardPanel::fail(const Error& error, const QString& cancelledText) {
    for (int step = 0; step < m_steps->count(); ++step) {
        if (m_steps->stepState(step) == widgets::StepState::Running) {
            endStep(step, widgets::StepState::Failed);
        }
    }
    m_pages->setCurrentIndex(0);
    if (const auto departure = departureMessage(m_bench.session(), error)) {
        m_departure = departure->text;
        m_message->showMessage(*departure);
    } else if (error.code == ErrorCode::Interrupted) {
        m_message->showMessage({widgets::Severity::Information, cancelledText, {}, {}});
    } else {
        showError(error);
    }
}

bool WizardPanel::isDepartureTold() const {
    return !m_departure.isEmpty() && m_message->message().text == m_departure;
}

void WizardPanel::showError(const Error& error) {
    m_message->showMessage(
        {widgets::Severity::Error, widgets::inWords(error.message), widgets::inWords(error.hint), {}});
}

ResultHeader WizardPanel::headerOf(const char* schema, std::uint64_t seed) const {
    ResultHeader header = m_bench.beginResult(schema);
    header.seed = seed;
    return header;
}

void WizardPanel::save(const FileQuestion& question, std::function<JsonValue()> document) {
    saveDocument(
        this, m_chooser, question, m_files, std::move(document),
        [this](const QString& path, const Result<void>& written) {
            if (written) {
                m_message->showMessage({widgets::Severity::Success, tr("Saved as %1").arg(path), {}, {}});
            } else {
                showError(written.error());
            }
        });
}

void WizardPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

void sayButton(QPushButton& button, const QString& text, const QString& help) {
    button.setText(text);
    button.setToolTip(help);
    button.setAccessibleName(text);
}

std::uint64_t seedOf(const devices::DeviceInfo& device) {
    for (const auto& [key, value] : device.overrides) {
        const auto seed = parseInteger(value);
        if (key == "seed" && seed && *seed >= 0) {
            return static_cast<std::uint64_t>(*seed);
        }
    }
    return 1;
}

} // namespace halbench::app
