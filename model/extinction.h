#pragma once

namespace model {

/// Extinction coefficient of the air, for the two-way transmission exp(-2 α r) of Beer and Lambert. [1/m]

/// α = 3.912 / V · (λ / 550 nm)^-q, Kruse's law with Kim's exponent q; 3.912 = -ln 0.02 (2 % contrast).
/// Source: Kruse et al. 1962; Kim, McArthur, Korevaar 2001, doi:10.1117/12.417512, eq. 4.
[[nodiscard]] double extinctionFromVisibility(double visibility_m, double wavelength_nm);

/// 1.076 R^0.67 dB/km. Source: Carbonneau & Wisely 1998, doi:10.1117/12.302454.
[[nodiscard]] double extinctionFromRain(double rain_rate_mm_h);

}  // namespace model
