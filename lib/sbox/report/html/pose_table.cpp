// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/html/pose_table.h"

#include <algorithm>
#include <cmath>

#include "sbox/core/number_text.h"

namespace sbox::html {
namespace {

constexpr double degrees = 180 / M_PI;
/// From this standard deviation on, in metres or in radians, nothing is known.
constexpr double unknown_metres = 100, unknown_radians = M_PI;

std::string cell(double value, double deviation, int digits, const std::string& unit,
                 double unknown_from) {
  std::string sure = " &plusmn; " + fixedDigits(deviation, digits);
  if (deviation == 0) {
    sure = "";
  } else if (!(deviation < unknown_from)) {
    sure = " &plusmn; ?";
  }
  return "<td class=\"number\">" + fixedDigits(value, digits) + sure + " " + unit + "</td>";
}

std::string covarianceTable(const PoseCovariance& covariance) {
  std::string text =
      "<details><summary>Covariance of (x, y, phi) in m&sup2;, m rad and rad&sup2;</summary>"
      "<table class=\"matrix\">";
  for (int row = 0; row < 3; ++row) {
    text += "<tr>";
    for (int column = 0; column < 3; ++column) {
      text += "<td class=\"number\">" + scientificDigits(covariance(row, column), 2) + "</td>";
    }
    text += "</tr>";
  }
  return text + "</table></details>\n";
}

}  // namespace

std::string poseCells(const Pose2D& pose, const PoseCovariance& covariance) {
  const auto deviation = [&](int i) { return std::sqrt(std::max(0.0, covariance(i, i))); };
  return cell(pose.x, deviation(0), 3, "m", unknown_metres) +
         cell(pose.y, deviation(1), 3, "m", unknown_metres) +
         cell(pose.phi * degrees, deviation(2) * degrees, 2, "&deg;", unknown_radians * degrees);
}

std::string poseTable(const Pose2D& pose, const PoseCovariance& covariance) {
  return "<table><thead><tr><th>x</th><th>y</th><th>phi</th></tr></thead><tbody><tr>" +
         poseCells(pose, covariance) + "</tr></tbody></table>\n" + covarianceTable(covariance);
}

std::string differenceText(const Pose2D& pose, const Pose2D& other) {
  return fixedDigits(std::hypot(pose.x - other.x, pose.y - other.y), 3) + " m and " +
         fixedDigits(std::abs(wrapAngle(pose.phi - other.phi)) * degrees, 2) + "&deg; apart";
}

}  // namespace sbox::html
