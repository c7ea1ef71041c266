// Markers in a stack of plots: dropped, found again, noted and removed by key.
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"
#include "widgets/live_plot/marker_bar.h"

#include <QAction>

#include <utility>

namespace halbench::widgets {
namespace {

/// What is so near, as a share of the view, is meant when a note is typed.
constexpr double Near_ratio = 0.02;
constexpr double Middle_ratio = 0.5;

} // namespace

void LivePlotStack::createMarkerActions() {
    addAction(Command::Marker, tr("Marker"), QStringLiteral("M"), tr("Add a marker at this time"));
    addAction(Command::MarkerNote, tr("Marker with a note"), QStringLiteral("Shift+M"),
              tr("Edit the note of the selected marker, of the marker at this time, or of a new one"));
    addAction(Command::NextMarker, tr("Next marker"), QStringLiteral("J"),
              tr("Select the next marker and show it"));
    addAction(Command::PreviousMarker, tr("Previous marker"), QStringLiteral("Shift+J"),
              tr("Select the previous marker and show it"));
    addAction(Command::RemoveMarker, tr("Remove the marker"), QStringLiteral("Del"),
              tr("Remove the selected marker"));
    addAction(Command::ListMarkers, tr("List of markers"), QStringLiteral("Ctrl+J"),
              tr("All markers with their notes"));
}

void LivePlotStack::connectMarkerBar() {
    m_markerBar->hide();
    m_markerBar->setActions({action(Command::MarkerNote), action(Command::NextMarker),
                             action(Command::PreviousMarker), action(Command::RemoveMarker)},
                            *action(Command::RemoveMarker));
    connect(m_markerBar, &MarkerBar::markerChosen, this,
            [this](int marker) { goToMarker(static_cast<std::size_t>(marker)); });
    connect(m_markerBar, &MarkerBar::noteTyped, this, &LivePlotStack::setNote);
    connect(m_markerBar, &MarkerBar::accepted, this, [this] { chooseMarker(std::nullopt); });
    connect(m_markerBar, &MarkerBar::cancelled, this, &LivePlotStack::cancelNote);
    placeMarkers();
}

void LivePlotStack::runOnMarkers(Command command) {
    switch (command) {
    case Command::Marker:
        dropMarker();
        return;
    case Command::MarkerNote:
        return noteMarker();
    case Command::RemoveMarker:
        return removeMarker();
    case Command::ListMarkers:
        if (!m_markers.empty()) {
            goToMarker(m_chosenMarker ? m_chosenMarker : markerBeside(m_markers, {}, 1));
            m_markerBar->showList();
        }
        return;
    default:
        return goToMarker(markerBeside(m_markers, m_chosenMarker, command == Command::NextMarker ? 1 : -1));
    }
}

/// Where the active cursor stands, else the newest sample.
double LivePlotStack::markedTime_s() const {
    return cursors().isVisible ? cursors().at(cursors().active) : m_view.now_s();
}

std::size_t LivePlotStack::dropMarker() {
    addMarker({markedTime_s(), freeMarkerNumber(m_markers)});
    return m_markers.size() - 1;
}

void LivePlotStack::addMarker(PlotMarker marker) {
    std::vector<PlotMarker> markers = m_markers;
    markers.push_back(std::move(marker));
    changeMarkers(std::move(markers));
}

void LivePlotStack::noteMarker() {
    m_isMarkerNew = false;
    if (!m_chosenMarker) {
        std::optional<std::size_t> marker =
            nearestMarker(m_markers, markedTime_s(), Near_ratio * activeView().range().length_s());
        m_isMarkerNew = !marker.has_value();
        chooseMarker(marker ? *marker : dropMarker());
    }
    m_markerBar->editNote();
}

/// One that is out of view comes into its middle; the view then stands still.
void LivePlotStack::goToMarker(std::optional<std::size_t> marker) {
    chooseMarker(marker);
    if (!m_chosenMarker) {
        return;
    }
    const control::TimeRange view = activeView().range();
    const double time_s = m_markers[*m_chosenMarker].time_s;
    if (time_s >= view.begin_s && time_s <= view.end_s) {
        return;
    }
    const bool wasFollowing = isFollowing();
    remember();
    const double begin_s = time_s - Middle_ratio * view.length_s();
    activeView().show({begin_s, begin_s + view.length_s()});
    changed(wasFollowing, isPaused());
}

void LivePlotStack::setNote(const QString& note) {
    if (!m_chosenMarker || m_markers[*m_chosenMarker].text == note) {
        return;
    }
    m_isMarkerNew = false;
    std::vector<PlotMarker> markers = m_markers;
    markers[*m_chosenMarker].text = note;
    changeMarkers(std::move(markers));
}

void LivePlotStack::removeMarker() {
    if (!m_chosenMarker) {
        return;
    }
    std::vector<PlotMarker> markers = m_markers;
    markers.erase(markers.begin() + static_cast<std::ptrdiff_t>(*m_chosenMarker));
    m_chosenMarker.reset();
    changeMarkers(std::move(markers));
}

/// What was dropped only for the note goes with it.
void LivePlotStack::cancelNote() {
    if (std::exchange(m_isMarkerNew, false)) {
        removeMarker();
    } else {
        chooseMarker(std::nullopt);
    }
}

void LivePlotStack::chooseMarker(std::optional<std::size_t> marker) {
    m_chosenMarker = marker && *marker < m_markers.size() ? marker : std::nullopt;
    placeMarkers();
}

/// Of another recording or device: none of them is chosen.
void LivePlotStack::setMarkers(std::vector<PlotMarker> markers) {
    m_chosenMarker.reset();
    m_isMarkerNew = false;
    changeMarkers(std::move(markers));
}

void LivePlotStack::changeMarkers(std::vector<PlotMarker> markers) {
    m_markers = std::move(markers);
    chooseMarker(m_chosenMarker);
    Q_EMIT markersChanged();
}

void LivePlotStack::setMarkersEditable(bool areEditable) {
    m_areMarkersEditable = areEditable;
    placeMarkers();
}

void LivePlotStack::placeMarkers() {
    for (const Row& row : m_rows) {
        row.plot->setMarkers(m_markers, m_chosenMarker);
    }
    m_markerBar->setMarkers(m_markers, m_chosenMarker, m_view.range().length_s());
    m_markerBar->setVisible(m_chosenMarker.has_value());
    m_actions.at(Command::Marker)->setEnabled(m_areMarkersEditable);
    m_actions.at(Command::MarkerNote)->setEnabled(m_areMarkersEditable);
    m_actions.at(Command::RemoveMarker)->setEnabled(m_areMarkersEditable && m_chosenMarker.has_value());
    m_isDirty = true;
}

} // namespace halbench::widgets
