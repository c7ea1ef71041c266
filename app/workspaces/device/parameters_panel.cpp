#include "app/workspaces/device/parameters_panel.h"

#include "app/documents/configuration_file.h"
#include "app/workspaces/parts/panel_parts.h"
#include "widgets/controls/message_bar.h"
#include "widgets/language/phrasebook.h"
#include "widgets/parameters/parameter_table.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {

namespace {

using Origin = widgets::ParameterTableModel::Origin;
constexpr int LookPeriod_ms = 250;
/// So few at a time that a stop never waits for them, even on a slow line.
constexpr std::size_t LookedAt = 12;

} // namespace

ParametersPanel::ParametersPanel(Workbench& bench, QWidget* parent, const QString& presetFolder)
    : QWidget(parent), m_bench(bench), m_folder(presetFolder) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0); // the table brings its own
    column->setSpacing(0);
    m_table = new widgets::ParameterTable(this);
    column->addWidget(m_table, 1);
    column->addWidget(buildPresets());
    connectTable();
    connect(&m_bench, &Workbench::deviceChanged, this, &ParametersPanel::onDevice);
    connect(&m_bench, &Workbench::valuesChanged, this, &ParametersPanel::onValues);
    connect(&m_bench.session(), &DeviceSession::procedureChanged, this, &ParametersPanel::onDevice);
    const auto useUnits = [this] { m_table->setAngleUnit(m_bench.displayUnits().angle); };
    connect(&m_bench, &Workbench::displayUnitsChanged, this, useUnits);
    useUnits();
    connect(&m_look, &QTimer::timeout, this, &ParametersPanel::look);
    m_look.start(LookPeriod_ms);
    onDevice();
}

QWidget* ParametersPanel::buildPresets() {
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(widgets::PanelMargin_px, 0, widgets::PanelMargin_px, widgets::PanelMargin_px);
    column->setSpacing(widgets::GridStep_px);
    m_presets = new QComboBox(box);
    m_presets->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // titles may be long
    m_presets->setMinimumContentsLength(26);
    m_presets->setAccessibleName(tr("Preset"));
    m_presets->setToolTip(tr("Named set of parameters, built-in or your own"));
    m_load = makeButton(
        {tr("Load"), tr("Load the preset into the rows; nothing is written yet"), QStringLiteral("open")},
        box);
    m_name = new QLineEdit(box);
    m_name->setAccessibleName(tr("Name of the new preset"));
    m_name->setPlaceholderText(tr("preset name"));
    m_name->setToolTip(tr("Save the edited column as a preset of this name (Enter)"));
    m_save = makeButton({tr("Save preset"),
                         tr("Save the edited column as a preset of this name (Enter in the name)"),
                         QStringLiteral("save")},
                        box);
    m_saveOnDevice = makeButton({tr("Save to device"),
                                 tr("Save the active values to non-volatile memory for the next power-up"),
                                 QStringLiteral("save")},
                                box);
    auto* loading = new QHBoxLayout;
    loading->addWidget(m_presets, 1);
    loading->addWidget(m_load);
    auto* saving = new QHBoxLayout;
    saving->addWidget(m_name, 1);
    saving->addWidget(m_save);
    column->addLayout(loading);
    column->addLayout(saving);
    column->addWidget(m_saveOnDevice);
    connect(m_load, &QPushButton::clicked, this, &ParametersPanel::loadChosen);
    connect(m_save, &QPushButton::clicked, this, &ParametersPanel::saveAs);
    connect(m_name, &QLineEdit::returnPressed, this, &ParametersPanel::saveAs);
    connect(m_saveOnDevice, &QPushButton::clicked, this, &ParametersPanel::saveOnDevice);
    return box;
}

void ParametersPanel::connectTable() {
    connect(m_table, &widgets::ParameterTable::writeRequested, this, &ParametersPanel::write);
    connect(m_table, &widgets::ParameterTable::readRequested, &m_bench, &Workbench::refreshValues);
}

void ParametersPanel::onDevice() {
    const DeviceSession& session = m_bench.session();
    const bool isConnected = session.state() == SessionState::Connected;
    if (isConnected && m_shown.empty()) {
        showDevice(session.catalogue());
    } else if (session.state() == SessionState::Connecting) {
        m_shown.clear(); // another device, another table
    }
    const bool isFree = isConnected && session.procedure().isEmpty();
    m_table->setOnline(isFree);
    for (QPushButton* button : {m_load, m_save, m_saveOnDevice}) {
        button->setEnabled(isFree);
    }
}

/// Orders to the board are no settings; what can only be read is shown all the same.
void ParametersPanel::showDevice(const devices::Catalogue& catalogue) {
    std::vector<ParameterSpec> specs;
    int readOnly = 0;
    for (const ParameterSpec& spec : catalogue.parameters) {
        ParameterSpec writable = spec;
        writable.access = ParameterAccess::ReadWrite;
        if (isSetting(writable)) {
            specs.push_back(spec);
            m_shown.push_back(spec.name);
            readOnly += spec.access == ParameterAccess::ReadOnly ? 1 : 0;
        }
    }
    m_table->setSpecs(std::move(specs));
    m_table->messages().clear();
    if (readOnly > 0) {
        m_table->messages().showMessage(
            {widgets::Severity::Information,
             tr("Read-only parameters: %1.").arg(readOnly),
             tr("The device does not allow writing to them or to its active page."),
             {}});
    }
    fillPresets();
}

/// A set of which more than one value lies outside the pages that the device can switch.
bool ParametersPanel::isOneByOne(const std::vector<ParameterValue>& values) const {
    const devices::Catalogue& catalogue = m_bench.session().catalogue();
    const auto plain = std::count_if(values.begin(), values.end(), [&](const ParameterValue& value) {
        const ParameterSpec* spec = catalogue.findParameter(value.name);
        return spec != nullptr && !spec->isTransactional;
    });
    return plain > 0 && values.size() > 1;
}

void ParametersPanel::onValues() {
    std::vector<ParameterValue> values;
    for (const std::string& name : m_shown) {
        if (const std::optional<double> value = m_bench.deviceValue(name)) {
            values.push_back({name, *value});
        }
    }
    if (!values.empty()) {
        m_table->model().setDeviceValues(values, m_bench.areValuesOurs() ? Origin::Written : Origin::Read);
    }
}

void ParametersPanel::tell(const QString& text, const QString& remedy) {
    m_table->messages().showMessage({widgets::Severity::Error, text, remedy, {}});
}

void ParametersPanel::tell(const Error& error) {
    tell(widgets::inWords(error.message), widgets::inWords(error.hint));
}

void ParametersPanel::write(const std::vector<ParameterValue>& changed) {
    m_bench.writeValues(changed, [self = QPointer(this), isOneByOne = isOneByOne(changed),
                                  count = static_cast<int>(changed.size())](const Result<void>& written) {
        if (!self) {
            return;
        }
        if (!written) {
            self->tell(written.error());
            self->m_bench.session().message(MessageLevel::Error, tr("parameters"),
                                            widgets::inWords(written.error().message));
            return;
        }
        const QString remedy = tr("Lost at power-off unless saved to the device.");
        self->m_table->messages().showMessage(
            {isOneByOne ? widgets::Severity::Warning : widgets::Severity::Success,
             tr("%n value(s) written and read back.", nullptr, count),
             isOneByOne ? tr("This device cannot write a complete set at once: values were changed one after "
                             "the other.") +
                              QLatin1Char(' ') + remedy
                        : remedy,
             {}});
    });
}

void ParametersPanel::saveOnDevice() {
    if (m_bench.session().info().isSimulated) {
        tell(tr("A simulated device cannot store values: it is reset at each connection."),
             tr("Save the values as a preset, or run the device with serve to keep them."));
        return;
    }
    m_bench.session().request(
        [](devices::Device& device) { return device.saveParameters(); },
        [self = QPointer(this)](const Result<void>& saved) {
            if (!self) {
                return;
            }
            if (!saved) {
                self->tell(saved.error());
                return;
            }
            const QString done = tr("Saved to the device.");
            self->m_bench.session().message(MessageLevel::Info, tr("parameters"), done);
            self->m_table->messages().showMessage(
                {widgets::Severity::Success, done, tr("Active from the next power-up on."), {}});
            Q_EMIT self->savedInDevice();
        });
}

void ParametersPanel::fillPresets(const QString& chosen) {
    const std::string model = m_bench.session().info().model;
    const QString shown = chosen.isEmpty() ? m_presets->currentText() : chosen;
    m_choices.clear(); // none of another model is to be had meanwhile
    m_presets->clear();
    m_files.run(
        [model, folder = m_folder]() -> Result<std::vector<PresetChoice>> {
            return presetChoices(model, folder);
        },
        [this, model, shown](const Result<std::vector<PresetChoice>>& choices) {
            if (model != m_bench.session().info().model) {
                return; // another device came, and its presets follow
            }
            m_choices = *choices;
            m_presets->clear();
            for (const PresetChoice& choice : m_choices) {
                m_presets->addItem(choice.title);
            }
            m_presets->setCurrentIndex(std::max(0, m_presets->findText(shown)));
        });
}

void ParametersPanel::loadChosen() {
    const int chosen = m_presets->currentIndex();
    if (chosen < 0) {
        return;
    }
    const std::string model = m_bench.session().info().model;
    m_files.run(
        [model, choice = m_choices[static_cast<std::size_t>(chosen)]] { return loadPreset(model, choice); },
        [this, model, title = m_presets->currentText()](const Result<Preset>& preset) {
            if (model == m_bench.session().info().model) {
                edit(title, preset);
            }
        });
}

/// As edits, one step of undo; what the device does not take is said by name.
void ParametersPanel::edit(const QString& title, const Result<Preset>& preset) {
    if (!preset) {
        tell(preset.error());
        return;
    }
    m_table->messages().clear();
    widgets::ParameterTableModel& model = m_table->model();
    QStringList refused;
    model.undoStack().beginMacro(tr("Load %1").arg(title));
    for (const ParameterValue& value : preset->values) {
        if (!model.edit(value.name, value.value)) {
            refused << QString::fromStdString(value.name);
        }
    }
    model.undoStack().endMacro();
    if (!refused.isEmpty()) {
        tell(tr("Not loaded from the preset: %1").arg(refused.join(QStringLiteral(", "))),
             tr("The device lacks these parameters or does not allow these values."));
    }
}

void ParametersPanel::saveAs() {
    Preset preset;
    preset.model = m_bench.session().info().model;
    preset.name = m_name->text().trimmed().toStdString();
    preset.title = preset.name;
    preset.source = m_bench.session().info().id;
    const std::vector<ParameterValue> edited = m_table->model().changedValues();
    for (const std::string& name : m_shown) {
        const auto change = std::find_if(edited.begin(), edited.end(),
                                         [&](const ParameterValue& value) { return value.name == name; });
        const std::optional<double> device = m_bench.deviceValue(name);
        if (change != edited.end()) {
            preset.values.push_back(*change);
        } else if (device) {
            preset.values.push_back({name, *device});
        }
    }
    m_files.run([preset, folder = m_folder] { return saveUserPreset(preset, folder); },
                [this, name = m_name->text().trimmed()](const Result<QString>& path) { kept(name, path); });
}

void ParametersPanel::kept(const QString& name, const Result<QString>& path) {
    if (!path) {
        tell(path.error());
        return;
    }
    fillPresets(name);
    m_name->clear();
    m_table->messages().showMessage(
        {widgets::Severity::Success, tr("Preset saved as %1.").arg(name), *path, {}});
}

/// Reads a few values after the other, so that one changed by another tool is noticed.
void ParametersPanel::look() {
    const DeviceSession& session = m_bench.session();
    if (!isVisible() || m_isLooking || m_shown.empty() || m_bench.deviceValues().empty() ||
        session.state() != SessionState::Connected || !session.procedure().isEmpty()) {
        return;
    }
    m_next = m_next < m_shown.size() ? m_next : 0;
    const std::size_t end = std::min(m_next + LookedAt, m_shown.size());
    const std::vector<std::string> names(m_shown.begin() + static_cast<std::ptrdiff_t>(m_next),
                                         m_shown.begin() + static_cast<std::ptrdiff_t>(end));
    m_next = end;
    m_isLooking = true;
    m_bench.session().request([names](devices::Device& device) { return device.readParameters(names); },
                              [self = QPointer(this), names](const Result<std::vector<double>>& values) {
                                  if (self) {
                                      self->m_isLooking = false;
                                      self->compare(names, values ? *values : std::vector<double>());
                                  }
                              });
}

void ParametersPanel::compare(const std::vector<std::string>& names, const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::optional<double> known = m_bench.deviceValue(names[i]);
        if (known && *known != values[i]) {
            m_bench.refreshValues();
            return;
        }
    }
}

} // namespace halbench::app
