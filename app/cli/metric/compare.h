#pragma once

#include <vector>

#include "app/cli/metric/result.h"
#include "app/cli/session.h"

namespace app {

/// One function a kind of data: reads the files of the request and computes its metrics.
std::vector<MeasurandResult> compareValues(const MetricRequest& request, const Session& session);
std::vector<MeasurandResult> compareSeries(const MetricRequest& request, const Session& session);
std::vector<MeasurandResult> comparePointClouds(const MetricRequest& request, const Session& session);
std::vector<MeasurandResult> compareRangeImages(const MetricRequest& request, const Session& session);
std::vector<MeasurandResult> compareOccupancyGrids(const MetricRequest& request, const Session& session);
std::vector<MeasurandResult> compareObjectLists(const MetricRequest& request, const Session& session);
std::vector<MeasurandResult> compareTracks(const MetricRequest& request, const Session& session);

/// What is wrong with a request before any file is opened. Throws InputError.
void mustHaveColumns(const MetricRequest& request);
void mustHaveNoColumns(const MetricRequest& request);
void mustHaveOneSimulation(const MetricRequest& request);

}  // namespace app
