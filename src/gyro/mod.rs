//! The gyrosphere family, its rectified error, and the rotating gimbal.
