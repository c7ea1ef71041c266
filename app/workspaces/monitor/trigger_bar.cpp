#include "app/workspaces/monitor/trigger_bar.h"

#include "app/workspaces/monitor/monitor_capture.h"
#include "app/workspaces/parts/field_grid.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/quantity_edit.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr int LeastCharacters = 8; ///< of the state
constexpr int SourceCharacters = 8;
constexpr int LevelCharacters = 13; ///< with unit and steps
constexpr int Columns = 5;
constexpr double LargestLevel = 1e6; ///< as shown
constexpr double LongestWindow_s = 600.0;
constexpr double ShortestWindow_s = 1e-3;
constexpr double PerCent = 100.0;
constexpr double MostBeforeOfBoard_ratio = 0.99;
enum From { Live, Board };

/// With a reason it cannot be chosen, and says why.
void setReason(QComboBox& box, int index, const QString& reason) {
    auto* items = static_cast<QStandardItemModel*>(box.model()); // what a box of its own has
    items->item(index)->setEnabled(reason.isEmpty());
    items->item(index)->setToolTip(reason);
}

/// It is narrower than its longest choice, which is read here.
void tellChoice(QComboBox& source) {
    source.setToolTip(TriggerBar::tr("Signal whose edge is the trigger event, or the set-point") +
                      QLatin1Char('\n') + source.currentText());
}

/// What the board can do of it.
TriggerChoice forBoard(TriggerChoice choice) {
    choice.mode = choice.mode == control::TriggerMode::Auto ? control::TriggerMode::Normal : choice.mode;
    choice.slope =
        choice.slope == control::TriggerSlope::Either ? control::TriggerSlope::Rising : choice.slope;
    choice.preTrigger_ratio = std::min(choice.preTrigger_ratio, MostBeforeOfBoard_ratio);
    return choice;
}

} // namespace

TriggerBar::TriggerBar(QAction& again, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(widgets::PanelMargin_px, 0, widgets::PanelMargin_px, widgets::GridStep_px);
    column->setSpacing(widgets::GridStep_px);
    auto* line = new QHBoxLayout;
    line->setSpacing(widgets::GridStep_px);
    buildEvent(*line);
    m_state = new widgets::ElidedLabel(LeastCharacters, this);
    m_state->setAccessibleName(tr("State of the trigger"));
    line->addWidget(m_state, 1);
    line->addWidget(new widgets::ActionButton(again, widgets::ActionButton::Shape::IconOnly, this));
    auto* more = makeButton(
        {{}, tr("Hysteresis, window and hold-off of the trigger"), QStringLiteral("settings")}, this);
    more->setAccessibleName(tr("More settings of the trigger"));
    more->setCheckable(true);
    line->addWidget(more);
    column->addLayout(line);
    auto* grid = new FieldGrid(Columns, this);
    buildSettings(*grid);
    grid->hide();
    connect(more, &QPushButton::toggled, grid, &QWidget::setVisible);
    column->addWidget(grid);
    showChoice();
}

/// Without titles: the fields read as a sentence, "Normal, Speed, rising, 10 r/min".
void TriggerBar::buildEvent(QHBoxLayout& line) {
    const auto addBox = [&](const QString& name, const QString& toolTip, const QStringList& items) {
        auto* box = new QComboBox(this);
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        box->addItems(items);
        box->setAccessibleName(name);
        box->setToolTip(toolTip);
        line.addWidget(box);
        return box;
    };
    m_from = addBox(tr("Event in"), {}, {tr("Live"), tr("Board")});
    m_mode = addBox(tr("Mode"),
                    tr("Auto: free-running without events; Normal: waits; Single: stops after one event"),
                    {tr("Auto"), tr("Normal"), tr("Single")});
    m_source = addBox(tr("Source"), {}, {});
    tellChoice(*m_source);
    m_source->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_source->setMinimumContentsLength(SourceCharacters);
    m_slope =
        addBox(tr("Slope"), tr("Slope of the trigger edge"), {tr("rising"), tr("falling"), tr("either")});
    watch(Level,
          makeNumberField({tr("Level"), tr("Trigger level; the line in the plot can be dragged")}, this));
    m_numbers[Level]->setMaximumWidth(LevelCharacters * fontMetrics().averageCharWidth());
    line.addWidget(m_numbers[Level]);
    connect(m_from, QOverload<int>::of(&QComboBox::activated), this,
            [this](int from) { onFrom(from == Board); });
    connect(m_mode, QOverload<int>::of(&QComboBox::activated), this, [this](int mode) {
        m_choice.mode = static_cast<control::TriggerMode>(mode);
        Q_EMIT edited();
    });
    connect(m_slope, QOverload<int>::of(&QComboBox::activated), this, [this](int slope) {
        m_choice.slope = static_cast<control::TriggerSlope>(slope);
        Q_EMIT edited();
    });
    connect(m_source, QOverload<int>::of(&QComboBox::activated), this, &TriggerBar::onSource);
}

void TriggerBar::buildSettings(FieldGrid& grid) {
    watch(Hysteresis,
          grid.addNumber({tr("Hysteresis"), tr("Distance from the level that re-arms the trigger")}));
    watch(Window, grid.addNumber({tr("Window"), tr("Time span of the triggered view")}));
    watch(Before, grid.addNumber({tr("Pre-trigger"), tr("Share of the window before the event")}));
    watch(HoldOff, grid.addNumber({tr("Hold-off"), tr("Minimum time between two events")}));
    m_middle = makeButton(
        {tr("Set level to 50 %"),
         tr("Set the level to the middle of the signal range in view, the hysteresis to 5 % of it"),
         {}},
        this);
    grid.addPlain(m_middle);
    connect(m_middle, &QPushButton::clicked, this, &TriggerBar::middleRequested);
}

void TriggerBar::watch(Field field, widgets::QuantityEdit* box) {
    m_numbers[field] = box;
    m_toolTips[field] = box->toolTip().section(QLatin1Char('\n'), 0, -2); // without its range
    connect(box, &widgets::QuantityEdit::edited, this,
            [this, field](double value) { onEdited(field, value); });
}

DisplayQuantity TriggerBar::shown() const {
    const SignalSpec* spec = m_catalogue.findSignal(m_choice.source);
    return spec != nullptr ? signalQuantity(*spec, m_units) : DisplayQuantity{};
}

void TriggerBar::setCatalogue(const devices::Catalogue& catalogue, const DisplayUnits& units,
                              std::vector<std::string> derived) {
    m_catalogue = catalogue;
    m_derived = std::move(derived);
    m_units = units;
    showChoice();
}

void TriggerBar::setChoice(const TriggerChoice& choice) {
    m_choice = choice.isBoard ? forBoard(choice) : choice;
    showChoice();
}

void TriggerBar::onFrom(bool isBoard) {
    m_choice.isBoard = isBoard;
    m_choice = isBoard ? forBoard(m_choice) : m_choice;
    showChoice();
    Q_EMIT edited();
}

void TriggerBar::showChoice() {
    fillSources();
    m_from->setCurrentIndex(m_choice.isBoard ? Board : Live);
    m_mode->setCurrentIndex(static_cast<int>(m_choice.mode));
    m_slope->setCurrentIndex(static_cast<int>(m_choice.slope));
    dressForBoard();
    dressFields();
}

void TriggerBar::fillSources() {
    const QSignalBlocker quiet(m_source);
    m_source->clear();
    if (m_choice.source.empty() || !m_catalogue.signalForRole("reference").empty()) {
        m_source->addItem(m_choice.isBoard ? tr("Reference start") : tr("Set-point change"), QString());
    }
    for (const SignalSpec& spec : m_catalogue.signals) {
        m_source->addItem(signalWords(spec.name), QString::fromStdString(spec.name));
        if (m_choice.isBoard && std::count(m_derived.begin(), m_derived.end(), spec.name) > 0) {
            setReason(*m_source, m_source->count() - 1,
                      tr("Not available on the device: computed in the program."));
        }
    }
    const QString source = QString::fromStdString(m_choice.source);
    if (m_source->findData(source) < 0) { // of another device: it is kept and said
        m_source->addItem(source, source);
    }
    m_source->setCurrentIndex(m_source->findData(source));
    tellChoice(*m_source);
}

/// What the board cannot do is there, and says so.
void TriggerBar::dressForBoard() {
    const auto unlessBoard = [this](const QString& reason) { return m_choice.isBoard ? reason : QString(); };
    const QString obstacle = m_catalogue.signals.empty() ? QString() : MonitorCapture::obstacle(m_catalogue);
    setReason(*m_from, Board, obstacle);
    m_from->setToolTip(obstacle.isEmpty()
                           ? tr("Live: searches the plotted samples. Board: the device waits and captures up "
                                "to 4 plotted signals at its loop rate, 4096 samples")
                           : tr("Live: searches the plotted samples. %1").arg(obstacle));
    setReason(*m_mode, static_cast<int>(control::TriggerMode::Auto),
              unlessBoard(tr("The device waits for its event and shows nothing without it.")));
    setReason(*m_slope, static_cast<int>(control::TriggerSlope::Either),
              unlessBoard(tr("The device detects one direction only.")));
}

void TriggerBar::dressFields() {
    const DisplayQuantity quantity = shown();
    const NumberField formats[Fields] = {
        {{}, {}, quantity.unit, quantity.decimals, -LargestLevel, LargestLevel, quantity.typical / 20.0},
        {{}, {}, quantity.unit, quantity.decimals, 0.0, LargestLevel, quantity.typical / 100.0},
        {{}, {}, QStringLiteral("s"), 3, ShortestWindow_s, LongestWindow_s, 0.1},
        {{},
         {},
         QStringLiteral("%"),
         0,
         0.0,
         m_choice.isBoard ? PerCent * MostBeforeOfBoard_ratio : PerCent,
         5.0},
        {{}, {}, QStringLiteral("s"), 3, 0.0, LongestWindow_s, 0.1},
    };
    const double values[Fields] = {quantity.factor * m_choice.level, quantity.factor * m_choice.hysteresis,
                                   m_choice.window_s, PerCent * m_choice.preTrigger_ratio,
                                   m_choice.holdOff_s};
    for (int field = 0; field < Fields; ++field) {
        const NumberField& format = formats[field];
        m_numbers[field]->setFormat({format.unit, format.min, format.max, format.step, format.decimals});
        m_numbers[field]->setQuantity(values[field]);
        m_numbers[field]->setToolTip(m_toolTips[field] + QLatin1Char('\n') + m_numbers[field]->toolTip());
    }
    const bool hasLevel = !m_choice.source.empty();
    for (QWidget* field :
         std::initializer_list<QWidget*>{m_slope, m_numbers[Level], m_numbers[Hysteresis], m_middle}) {
        field->setEnabled(hasLevel);
    }
    m_numbers[HoldOff]->setEnabled(!m_choice.isBoard);
    if (m_choice.isBoard) {
        m_numbers[Hysteresis]->setEnabled(false);
        m_numbers[Hysteresis]->setToolTip(tr("The device has no hysteresis: each crossing is an event."));
        m_numbers[HoldOff]->setToolTip(
            tr("The device has no hold-off: it re-arms after its capture is read."));
    }
}

void TriggerBar::onEdited(Field field, double value) {
    const double factor = shown().factor;
    switch (field) {
    case Level:
        m_choice.level = value / factor;
        break;
    case Hysteresis:
        m_choice.hysteresis = value / factor;
        break;
    case Window:
        m_choice.window_s = value;
        break;
    case Before:
        m_choice.preTrigger_ratio = value / PerCent;
        break;
    case HoldOff:
    case Fields:
        m_choice.holdOff_s = value;
        break;
    }
    Q_EMIT edited();
}

void TriggerBar::onSource(int index) {
    m_choice.source = m_source->itemData(index).toString().toStdString();
    tellChoice(*m_source);
    m_choice.level = 0.0;
    m_choice.hysteresis = 0.0;
    dressFields();
    Q_EMIT sourceChosen();
}

void TriggerBar::setState(const QString& words, const QString& sentence, widgets::Role role) {
    if (m_state->accessibleDescription() != sentence || m_state->words() != words) {
        m_state->setWords(words);
        m_state->setToolTip(sentence);
        m_state->setAccessibleDescription(sentence);
    }
    showRole(*m_state, role);
}

QString TriggerBar::eventWords() const {
    if (m_choice.source.empty()) {
        return m_choice.isBoard ? tr("the reference starts") : tr("the set-point changes");
    }
    const QString level = m_numbers[Level]->text();
    const QString source = signalWords(m_choice.source);
    switch (m_choice.slope) {
    case control::TriggerSlope::Rising:
        return tr("%1 rises through %2").arg(source, level);
    case control::TriggerSlope::Falling:
        return tr("%1 falls through %2").arg(source, level);
    case control::TriggerSlope::Either:
        break;
    }
    return tr("%1 passes %2").arg(source, level);
}

} // namespace halbench::app
