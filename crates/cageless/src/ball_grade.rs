//! Grades of balls (ISO 3290-1:2014, steel balls).

/// A grade with what it admits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallGrade {
    /// Number of the grade: 10 for G10.
    pub number: u32,
    /// VDwL, largest difference of the mean diameters of two balls of a lot.
    pub lot_variation_m: f64,
}

const fn grade(number: u32, lot_variation_m: f64) -> BallGrade {
    BallGrade {
        number,
        lot_variation_m,
    }
}

/// Variation of the ball lot diameter of every grade of the standard.
const BALL_GRADES: [BallGrade; 11] = [
    grade(3, 0.13e-6),
    grade(5, 0.25e-6),
    grade(10, 0.5e-6),
    grade(16, 0.8e-6),
    grade(20, 1e-6),
    grade(24, 1.2e-6),
    grade(28, 1.4e-6),
    grade(40, 2e-6),
    grade(60, 3e-6),
    grade(100, 5e-6),
    grade(200, 10e-6),
];

/// Numbers of all grades for messages: `3, 5, 10, …`.
pub fn ball_grades_text() -> String {
    let numbers: Vec<String> = BALL_GRADES.iter().map(|g| g.number.to_string()).collect();
    numbers.join(", ")
}

/// The grade of a number; `None` if the standard has none.
pub fn ball_grade(number: u32) -> Option<BallGrade> {
    BALL_GRADES.into_iter().find(|g| g.number == number)
}

impl BallGrade {
    /// Largest deviation of a ball's radius from the middle of its lot.
    pub fn radius_deviation_m(self) -> f64 {
        self.lot_variation_m / 4.0
    }
}
