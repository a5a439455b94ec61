#include <algorithm>
#include <array>
#include <set>
#include <sstream>
#include <string>

#include "text/identifier.hpp"

namespace treeline {
namespace {

// clang-format off
constexpr const char* kKeywords =
    "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t "
    "char32_t char8_t class co_await co_return co_yield compl concept const const_cast consteval "
    "constexpr constinit continue decltype default delete do double dynamic_cast else enum "
    "explicit export extern false float for friend goto if inline int long mutable namespace new "
    "noexcept not not_eq nullptr operator or or_eq private protected public register "
    "reinterpret_cast requires restrict return short signed sizeof static static_assert static_cast struct "
    "switch template this thread_local throw true try typedef typeid typename union unsigned "
    "using virtual void volatile wchar_t while xor xor_eq ";

/// Macros of the headers of C and of <math.h> and <unistd.h> as they are usually found; those of
/// <inttypes.h> and <stdint.h> are told by their form.
constexpr const char* kMacros =
    "BUFSIZ CHAR_BIT CHAR_MAX CHAR_MIN CLOCKS_PER_SEC CMPLX CMPLXF CMPLXL DBL_DECIMAL_DIG DBL_DIG "
    "DBL_EPSILON DBL_HAS_SUBNORM DBL_MANT_DIG DBL_MAX DBL_MAX_10_EXP DBL_MAX_EXP DBL_MIN "
    "DBL_MIN_10_EXP DBL_MIN_EXP DBL_TRUE_MIN DECIMAL_DIG DOMAIN E2BIG EACCES EADDRINUSE "
    "EADDRNOTAVAIL EADV EAFNOSUPPORT EAGAIN EALREADY EBADE EBADF EBADFD EBADMSG EBADR EBADRQC "
    "EBADSLT EBFONT EBUSY ECANCELED ECHILD ECHRNG ECOMM ECONNABORTED ECONNREFUSED ECONNRESET "
    "EDEADLK EDEADLOCK EDESTADDRREQ EDOM EDOTDOT EDQUOT EEXIST EFAULT EFBIG EHOSTDOWN "
    "EHOSTUNREACH EHWPOISON EIDRM EILSEQ EINPROGRESS EINTR EINVAL EIO EISCONN EISDIR EISNAM "
    "EKEYEXPIRED EKEYREJECTED EKEYREVOKED EL2HLT EL2NSYNC EL3HLT EL3RST ELIBACC ELIBBAD ELIBEXEC "
    "ELIBMAX ELIBSCN ELNRNG ELOOP EMEDIUMTYPE EMFILE EMLINK EMSGSIZE EMULTIHOP ENAMETOOLONG "
    "ENAVAIL ENETDOWN ENETRESET ENETUNREACH ENFILE ENOANO ENOBUFS ENOCSI ENODATA ENODEV ENOENT "
    "ENOEXEC ENOKEY ENOLCK ENOLINK ENOMEDIUM ENOMEM ENOMSG ENONET ENOPKG ENOPROTOOPT ENOSPC ENOSR "
    "ENOSTR ENOSYS ENOTBLK ENOTCONN ENOTDIR ENOTEMPTY ENOTNAM ENOTRECOVERABLE ENOTSOCK ENOTSUP "
    "ENOTTY ENOTUNIQ ENXIO EOF EOPNOTSUPP EOVERFLOW EOWNERDEAD EPERM EPFNOSUPPORT EPIPE EPROTO "
    "EPROTONOSUPPORT EPROTOTYPE ERANGE EREMCHG EREMOTE EREMOTEIO ERESTART ERFKILL EROFS ESHUTDOWN "
    "ESOCKTNOSUPPORT ESPIPE ESRCH ESRMNT ESTALE ESTRPIPE ETIME ETIMEDOUT ETOOMANYREFS ETXTBSY "
    "EUCLEAN EUNATCH EUSERS EWOULDBLOCK EXDEV EXFULL EXIT_FAILURE EXIT_SUCCESS FE_ALL_EXCEPT "
    "FE_DFL_ENV FE_DIVBYZERO FE_DOWNWARD FE_INEXACT FE_INVALID FE_OVERFLOW FE_TONEAREST "
    "FE_TOWARDZERO FE_UNDERFLOW FE_UPWARD FILENAME_MAX FLT_DECIMAL_DIG FLT_DIG FLT_EPSILON "
    "FLT_EVAL_METHOD FLT_HAS_SUBNORM FLT_MANT_DIG FLT_MAX FLT_MAX_10_EXP FLT_MAX_EXP FLT_MIN "
    "FLT_MIN_10_EXP FLT_MIN_EXP FLT_RADIX FLT_ROUNDS FLT_TRUE_MIN FOPEN_MAX FP_ILOGB0 FP_ILOGBNAN "
    "FP_INFINITE FP_NAN FP_NORMAL FP_SUBNORMAL FP_ZERO F_OK HUGE HUGE_VAL HUGE_VALF HUGE_VALL I "
    "INFINITY IOV_MAX LDBL_DECIMAL_DIG LDBL_DIG LDBL_EPSILON LDBL_HAS_SUBNORM LDBL_MANT_DIG "
    "LDBL_MAX LDBL_MAX_10_EXP LDBL_MAX_EXP LDBL_MIN LDBL_MIN_10_EXP LDBL_MIN_EXP LDBL_TRUE_MIN "
    "LINE_MAX LLONG_MAX LLONG_MIN LONG_MAX LONG_MIN L_INCR L_SET L_XTND L_tmpnam MAP_FAILED "
    "MATH_ERREXCEPT MATH_ERRNO MAXFLOAT MB_CUR_MAX MB_LEN_MAX M_1_PI M_2_PI M_2_SQRTPI M_E M_LN10 "
    "M_1_PIl M_2_PIl M_2_SQRTPIl M_El M_LN10l M_LN2l M_LOG10El M_LOG2El M_PIl M_PI_2l M_PI_4l "
    "M_SQRT1_2l M_SQRT2l "
    "M_LN2 M_LOG10E M_LOG2E M_PI M_PI_2 M_PI_4 M_SQRT1_2 M_SQRT2 NAN NULL OVERFLOW PATH_MAX PLOSS "
    "PTRDIFF_MAX PTRDIFF_MIN RAND_MAX R_OK SCHAR_MAX SCHAR_MIN SEEK_CUR SEEK_END SEEK_SET "
    "SHRT_MAX SHRT_MIN SIGABRT SIGALRM SIGBUS SIGCHLD SIGCLD SIGCONT SIGFPE SIGHUP SIGILL SIGINT "
    "SIGIO SIGIOT SIGKILL SIGPIPE SIGPOLL SIGPROF SIGPWR SIGQUIT SIGRTMAX SIGRTMIN SIGSEGV "
    "SIGSTKFLT SIGSTOP SIGSYS SIGTERM SIGTRAP SIGTSTP SIGTTIN SIGTTOU SIGURG SIGUSR1 SIGUSR2 "
    "SIGVTALRM SIGWINCH SIGXCPU SIGXFSZ SIG_ATOMIC_MAX SIG_ATOMIC_MIN SIG_DFL SIG_ERR SIG_IGN "
    "SING SIZE_MAX SNAN SNANF SSIZE_MAX TIME_UTC TLOSS TMP_MAX UCHAR_MAX ULLONG_MAX ULONG_MAX "
    "UNDERFLOW USHRT_MAX WCHAR_MAX WCHAR_MIN WEOF WINT_MAX WINT_MIN W_OK X_OK alloca assert "
    "complex errno fpclassify i386 isalnum isalpha isblank iscntrl isdigit isfinite isgraph "
    "isgreater isgreaterequal isinf isless islessequal islessgreater islower isnan isnormal "
    "isprint ispunct isspace isunordered isupper isxdigit linux major makedev math_errhandling "
    "minor offsetof sa_handler setjmp si_pid si_uid si_value signbit st_atime st_ctime st_mtime "
    "stderr stdin stdout strtoq unix va_arg va_copy va_end va_start ";

/// Functions, objects and types that those headers declare at global scope, and what emitted code
/// calls its number type.
constexpr const char* kGlobals =
    "Real main posix std "
    "FILE a64l abort abs accept access acct acos acosf acosh acoshf acoshl acosl alarm "
    "aligned_alloc arc4random arc4random_buf arc4random_uniform asctime asin asinf asinh asinhf "
    "asinhl asinl at_quick_exit atan atan2 atan2f atan2l atanf atanh atanhf atanhl atanl atexit "
    "atof atoi atol atoll bcmp bcopy bind brk bsearch btowc bzero c16rtomb c32rtomb calloc cbrt "
    "cbrtf cbrtl ceil ceilf ceill chdir chmod chown chroot clearenv clearerr clock "
    "clock_getcpuclockid clock_getres clock_gettime clock_nanosleep clock_settime clock_t close "
    "closefrom cmsghdr confstr connect copysign copysignf copysignl cos cosf cosh coshf coshl "
    "cosl creat crypt ctermid ctime daemon daylight difftime div div_t double_t dprintf drem "
    "dremf dreml dup dup2 duplocale dysize ecvt endusershell erf erfc erfcf erfcl erff erfl execl "
    "execle execlp execv execve execvp exit exp exp2 exp2f exp2l expf expl explicit_bzero expm1 "
    "expm1f expm1l fabs fabsf fabsl faccessat fchdir fchmod fchmodat fchown fchownat fclose fcntl "
    "fcvt fd_mask fd_set fdatasync fdim fdimf fdiml fdopen feclearexcept fegetenv fegetexceptflag "
    "fegetround feholdexcept fenv_t feof feraiseexcept ferror fesetenv fesetexceptflag fesetround "
    "fetestexcept feupdateenv fexcept_t fexecve fflush ffs ffsl ffsll fgetc fgetpos fgets fgetwc "
    "fgetws fileno finite finitef finitel float_t flock flockfile floor floorf floorl fma fmaf "
    "fmal fmax fmaxf fmaxl fmemopen fmin fminf fminl fmod fmodf fmodl fopen fork fpathconf fpos_t "
    "fprintf fputc fputs fputwc fputws fread free freelocale freopen frexp frexpf frexpl fscanf "
    "fseek fseeko fsetpos fstat fstatat fsync ftell ftello ftruncate ftrylockfile funlockfile "
    "futimens fwide fwprintf fwrite fwscanf gamma gammaf gammal gcvt getc getchar getcwd getdelim "
    "getdomainname getdtablesize getegid getentropy getenv geteuid getgid getgroups gethostid "
    "gethostname getline getloadavg getlogin getopt getpagesize getpass getpeername getpgid "
    "getpgrp getpid getppid getsid getsockname getsockopt getsubopt getuid getusershell getw "
    "getwc getwchar getwd gmtime gsignal hypot hypotf hypotl ilogb ilogbf ilogbl imaxabs imaxdiv "
    "imaxdiv_t index initstate int16_t int32_t int64_t int8_t int_fast16_t int_fast32_t "
    "int_fast64_t int_fast8_t int_least16_t int_least32_t int_least64_t int_least8_t intmax_t "
    "intptr_t iovec isascii isatty isfdtype isinff isinfl isnanf isnanl iswalnum iswalpha "
    "iswblank iswcntrl iswctype iswdigit iswgraph iswlower iswprint iswpunct iswspace iswupper "
    "iswxdigit itimerspec j0 j0f j0l j1 j1f j1l jmp_buf jn jnf jnl kill killpg l64a labs lchmod "
    "lchown lconv ldexp ldexpf ldexpl ldiv ldiv_t lgamma lgammaf lgammal linger link linkat "
    "listen llabs lldiv lldiv_t llrint llrintf llrintl llround llroundf llroundl localeconv "
    "localtime lockf log log10 log10f log10l log1p log1pf log1pl log2 log2f log2l logb logbf "
    "logbl logf logl longjmp lrint lrintf lrintl lround lroundf lroundl lseek lstat madvise "
    "malloc max_align_t mblen mbrlen mbrtoc16 mbrtoc32 mbrtowc mbsinit mbsnrtowcs mbsrtowcs "
    "mbstate_t mbstowcs mbtowc memccpy memchr memcmp memcpy memmove memset mincore mkdir mkdirat "
    "mkdtemp mkfifo mkfifoat mknod mknodat mkstemp mkstemps mktemp mktime mlock mlockall mmap "
    "modf modff modfl mprotect msghdr msync munlock munlockall munmap nan nanf nanl nanosleep "
    "nearbyint nearbyintf nearbyintl newlocale nextafter nextafterf nextafterl nexttoward "
    "nexttowardf nexttowardl nice on_exit open open_memstream open_wmemstream openat optarg "
    "opterr optind optopt osockaddr pathconf pause pclose perror pipe popen posix_fadvise "
    "posix_fallocate posix_madvise posix_memalign pow powf powl pread printf profil pselect "
    "psiginfo psignal ptrdiff_t putc putchar putenv puts putw putwc putwchar pwrite qecvt qfcvt "
    "qgcvt qsort quick_exit raise rand random random_data read readlink readlinkat realloc "
    "reallocarray realpath recv recvfrom recvmsg remainder remainderf remainderl remove remquo "
    "remquof remquol rename renameat revoke rewind rindex rint rintf rintl rmdir round roundf "
    "roundl rpmatch sbrk scalb scalbf scalbl scalbln scalblnf scalblnl scalbn scalbnf scalbnl "
    "scanf select send sendmsg sendto setbuf setbuffer setdomainname setegid setenv seteuid "
    "setgid sethostid sethostname setlinebuf setlocale setlogin setpgid setpgrp setregid setreuid "
    "setsid setsockopt setstate setuid setusershell setvbuf shm_open shm_unlink shutdown "
    "sig_atomic_t sigaction sigaddset sigaltstack sigblock sigcontext sigdelset sigemptyset "
    "sigevent sigfillset siggetmask siginterrupt sigismember sigjmp_buf siglongjmp signal signgam "
    "significand significandf significandl sigpending sigprocmask sigqueue sigreturn sigsetmask "
    "sigstack sigsuspend sigtimedwait sigval sigwait sigwaitinfo sin sinf sinh sinhf sinhl sinl "
    "size_t sleep snprintf sockaddr sockaddr_storage sockatmark socket socketpair sprintf sqrt "
    "sqrtf sqrtl srand srandom sscanf ssignal stat stpcpy stpncpy strcasecmp strcat strchr strcmp "
    "strcoll strcpy strcspn strdup strerror strftime strlen strncasecmp strncat strncmp strncpy "
    "strndup strnlen strpbrk strrchr strsep strsignal strspn strstr strtod strtof strtoimax "
    "strtok strtol strtold strtoll strtoul strtoull strtoumax strtouq strxfrm swprintf swscanf "
    "symlink symlinkat sync syscall sysconf system tan tanf tanh tanhf tanhl tanl tcgetpgrp "
    "tcsetpgrp tempnam tgamma tgammaf tgammal time time_t timegm timelocal timer_create "
    "timer_delete timer_getoverrun timer_gettime timer_settime timespec timespec_get timeval "
    "timezone tm tmpfile tmpnam toascii tolower toupper towctrans towlower towupper trunc "
    "truncate truncf truncl ttyname ttyslot tzname tzset u_char u_int u_long u_short ualarm uint "
    "uint16_t uint32_t uint64_t uint8_t uint_fast16_t uint_fast32_t uint_fast64_t uint_fast8_t "
    "uint_least16_t uint_least32_t uint_least64_t uint_least8_t uintmax_t uintptr_t ulong umask "
    "ungetc ungetwc unlink unlinkat unsetenv uselocale ushort usleep utimensat va_list valloc "
    "vdprintf vfork vfprintf vfscanf vfwprintf vfwscanf vhangup vprintf vscanf vsnprintf vsprintf "
    "vsscanf vswprintf vswscanf vwprintf vwscanf wcpcpy wcpncpy wcrtomb wcscasecmp wcscat wcschr "
    "wcscmp wcscoll wcscpy wcscspn wcsdup wcsftime wcslen wcsncasecmp wcsncat wcsncmp wcsncpy "
    "wcsnlen wcsnrtombs wcspbrk wcsrchr wcsrtombs wcsspn wcsstr wcstod wcstof wcstoimax wcstok "
    "wcstol wcstold wcstoll wcstombs wcstoul wcstoull wcstoumax wcsxfrm wctob wctomb wctrans "
    "wctrans_t wctype wctype_t wint_t wmemchr wmemcmp wmemcpy wmemmove wmemset wprintf write "
    "wscanf y0 y0f y0l y1 y1f y1l yn ynf ynl ";
/// What the headers of POSIX, of threads and of Linux define beside, which g++ and clang++ show unless
/// told otherwise; those of one family are told by their form.
constexpr const char* kPosix =
    "ACCESSPERMS ADJ_ESTERROR ADJ_FREQUENCY ADJ_MAXERROR ADJ_MICRO ADJ_NANO ADJ_OFFSET "
    "ADJ_OFFSET_SINGLESHOT ADJ_OFFSET_SS_READ ADJ_SETOFFSET ADJ_STATUS ADJ_TAI ADJ_TICK "
    "ADJ_TIMECONST AF_DECnet AIO_PRIO_DELTA_MAX ALLPERMS AT_EACCESS AT_EMPTY_PATH AT_FDCWD "
    "AT_NO_AUTOMOUNT AT_RECURSIVE AT_REMOVEDIR AT_STATX_DONT_SYNC AT_STATX_FORCE_SYNC "
    "AT_STATX_SYNC_AS_STAT AT_STATX_SYNC_TYPE AT_SYMLINK_FOLLOW AT_SYMLINK_NOFOLLOW BC_BASE_MAX "
    "BC_DIM_MAX BC_SCALE_MAX BC_STRING_MAX BIG_ENDIAN BOOL_MAX BOOL_WIDTH BUS_ADRALN BUS_ADRERR "
    "BUS_MCEERR_AO BUS_MCEERR_AR BUS_OBJERR BYTE_ORDER CHARCLASS_NAME_MAX CHAR_WIDTH CLD_CONTINUED "
    "CLD_DUMPED CLD_EXITED CLD_KILLED CLD_STOPPED CLD_TRAPPED CLOSE_RANGE_CLOEXEC "
    "CLOSE_RANGE_UNSHARE CMSG_ALIGN CMSG_DATA CMSG_FIRSTHDR CMSG_LEN CMSG_NXTHDR CMSG_SPACE "
    "COLL_WEIGHTS_MAX CPU_ALLOC CPU_ALLOC_SIZE CPU_AND CPU_AND_S CPU_CLR CPU_CLR_S CPU_COUNT "
    "CPU_COUNT_S CPU_EQUAL CPU_EQUAL_S CPU_FREE CPU_ISSET CPU_ISSET_S CPU_OR CPU_OR_S CPU_SET "
    "CPU_SETSIZE CPU_SET_S CPU_XOR CPU_XOR_S CPU_ZERO CPU_ZERO_S CSIGNAL DEFFILEMODE "
    "DELAYTIMER_MAX DN_ACCESS DN_ATTRIB DN_CREATE DN_DELETE DN_MODIFY DN_MULTISHOT DN_RENAME "
    "EXPR_NEST_MAX FAPPEND FASYNC FD_CLOEXEC FD_CLR FD_ISSET FD_SET FD_SETSIZE FD_ZERO FE_DFL_MODE "
    "FE_NOMASK_ENV FFSYNC FIOGETOWN FIOSETOWN FNDELAY FNONBLOCK FPE_CONDTRAP FPE_FLTDIV FPE_FLTINV "
    "FPE_FLTOVF FPE_FLTRES FPE_FLTSUB FPE_FLTUND FPE_FLTUNK FPE_INTDIV FPE_INTOVF FP_INT_DOWNWARD "
    "FP_INT_TONEAREST FP_INT_TONEARESTFROMZERO FP_INT_TOWARDZERO FP_INT_UPWARD FP_LLOGB0 "
    "FP_LLOGBNAN FP_XSTATE_MAGIC1 FP_XSTATE_MAGIC2 FP_XSTATE_MAGIC2_SIZE F_ADD_SEALS F_DUPFD "
    "F_DUPFD_CLOEXEC F_EXLCK F_GETFD F_GETFL F_GETLEASE F_GETLK F_GETOWN F_GETOWN_EX F_GETPIPE_SZ "
    "F_GETSIG F_GET_FILE_RW_HINT F_GET_RW_HINT F_GET_SEALS F_LOCK F_NOTIFY F_OFD_GETLK F_OFD_SETLK "
    "F_OFD_SETLKW F_OWNER_GID F_OWNER_PGRP F_OWNER_PID F_OWNER_TID F_RDLCK F_SEAL_FUTURE_WRITE "
    "F_SEAL_GROW F_SEAL_SEAL F_SEAL_SHRINK F_SEAL_WRITE F_SETFD F_SETFL F_SETLEASE F_SETLK "
    "F_SETLKW F_SETOWN F_SETOWN_EX F_SETPIPE_SZ F_SETSIG F_SET_FILE_RW_HINT F_SET_RW_HINT F_SHLCK "
    "F_TEST F_TLOCK F_ULOCK F_UNLCK F_WRLCK HOST_NAME_MAX HUGE_VAL_F128 HUGE_VAL_F32 HUGE_VAL_F32X "
    "HUGE_VAL_F64 HUGE_VAL_F64X ILL_BADIADDR ILL_BADSTK ILL_COPROC ILL_ILLADR ILL_ILLOPC "
    "ILL_ILLOPN ILL_ILLTRP ILL_PRVOPC ILL_PRVREG ITIMER_PROF ITIMER_REAL ITIMER_VIRTUAL "
    "LITTLE_ENDIAN LLONG_WIDTH LOCK_EX LOCK_MAND LOCK_NB LOCK_READ LOCK_RW LOCK_SH LOCK_UN "
    "LOCK_WRITE LOGIN_NAME_MAX LONG_BIT LONG_LONG_MAX LONG_LONG_MIN LONG_WIDTH L_ctermid L_cuserid "
    "MAP_32BIT MAP_ANON MAP_ANONYMOUS MAP_DENYWRITE MAP_EXECUTABLE MAP_FILE MAP_FIXED "
    "MAP_FIXED_NOREPLACE MAP_GROWSDOWN MAP_HUGETLB MAP_HUGE_MASK MAP_HUGE_SHIFT MAP_LOCKED "
    "MAP_NONBLOCK MAP_NORESERVE MAP_POPULATE MAP_PRIVATE MAP_SHARED MAP_SHARED_VALIDATE MAP_STACK "
    "MAP_SYNC MAP_TYPE MAX_CANON MAX_HANDLE_SZ MAX_INPUT MCL_CURRENT MCL_FUTURE MCL_ONFAULT "
    "MFD_ALLOW_SEALING MFD_CLOEXEC MFD_HUGETLB MINSIGSTKSZ MLOCK_ONFAULT MOD_CLKA MOD_CLKB "
    "MOD_ESTERROR MOD_FREQUENCY MOD_MAXERROR MOD_MICRO MOD_NANO MOD_OFFSET MOD_STATUS MOD_TAI "
    "MOD_TIMECONST MQ_PRIO_MAX MREMAP_DONTUNMAP MREMAP_FIXED MREMAP_MAYMOVE MSG_BATCH "
    "MSG_CMSG_CLOEXEC MSG_CONFIRM MSG_CTRUNC MSG_DONTROUTE MSG_DONTWAIT MSG_EOR MSG_ERRQUEUE "
    "MSG_FASTOPEN MSG_FIN MSG_MORE MSG_NOSIGNAL MSG_OOB MSG_PEEK MSG_PROXY MSG_RST MSG_SYN "
    "MSG_TRUNC MSG_TRYHARD MSG_WAITALL MSG_WAITFORONE MSG_ZEROCOPY MS_ASYNC MS_INVALIDATE MS_SYNC "
    "M_1_PIf M_2_PIf M_2_SQRTPIf M_ARENA_MAX M_ARENA_TEST M_CHECK_ACTION M_Ef M_GRAIN M_KEEP "
    "M_LN10f M_LN2f M_LOG10Ef M_LOG2Ef M_MMAP_MAX M_MMAP_THRESHOLD M_MXFAST M_NLBLKS M_PERTURB "
    "M_PI_2f M_PI_4f M_PIf M_SQRT1_2f M_SQRT2f M_TOP_PAD M_TRIM_THRESHOLD NAME_MAX NFDBITS NGREG "
    "NGROUPS_MAX NL_ARGMAX NL_LANGMAX NL_MSGMAX NL_NMAX NL_SETMAX NL_TEXTMAX NSIG NZERO "
    "ONCE_FLAG_INIT O_ACCMODE O_APPEND O_ASYNC O_CLOEXEC O_CREAT O_DIRECT O_DIRECTORY O_DSYNC "
    "O_EXCL O_FSYNC O_LARGEFILE O_NDELAY O_NOATIME O_NOCTTY O_NOFOLLOW O_NONBLOCK O_PATH O_RDONLY "
    "O_RDWR O_RSYNC O_SYNC O_TMPFILE O_TRUNC O_WRONLY PDP_ENDIAN PF_DECnet PIPE_BUF "
    "PKEY_DISABLE_ACCESS PKEY_DISABLE_WRITE POLLERR POLLHUP POLLIN POLLMSG POLLNVAL POLLOUT "
    "POLLPRI POLLRDBAND POLLRDHUP POLLRDNORM POLLREMOVE POLLWRBAND POLLWRNORM POLL_ERR POLL_HUP "
    "POLL_IN POLL_MSG POLL_OUT POLL_PRI PRIO_MAX PRIO_MIN PRIO_PGRP PRIO_PROCESS PRIO_USER "
    "PROT_EXEC PROT_GROWSDOWN PROT_GROWSUP PROT_NONE PROT_READ PROT_WRITE PTRDIFF_WIDTH P_tmpdir "
    "REG_CR2 REG_CSGSFS REG_EFL REG_ERR REG_OLDMASK REG_R10 REG_R11 REG_R12 REG_R13 REG_R14 "
    "REG_R15 REG_R8 REG_R9 REG_RAX REG_RBP REG_RBX REG_RCX REG_RDI REG_RDX REG_RIP REG_RSI REG_RSP "
    "REG_TRAPNO RENAME_EXCHANGE RENAME_NOREPLACE RENAME_WHITEOUT RE_DUP_MAX RLIM64_INFINITY "
    "RLIM_INFINITY RLIM_NLIMITS RLIM_SAVED_CUR RLIM_SAVED_MAX RTSIG_MAX RUSAGE_CHILDREN RUSAGE_LWP "
    "RUSAGE_SELF RUSAGE_THREAD RWF_APPEND RWF_DSYNC RWF_HIPRI RWF_NOAPPEND RWF_NOWAIT RWF_SYNC "
    "RWF_WRITE_LIFE_NOT_SET RWH_WRITE_LIFE_EXTREME RWH_WRITE_LIFE_LONG RWH_WRITE_LIFE_MEDIUM "
    "RWH_WRITE_LIFE_NONE RWH_WRITE_LIFE_NOT_SET RWH_WRITE_LIFE_SHORT SA_INTERRUPT SA_NOCLDSTOP "
    "SA_NOCLDWAIT SA_NODEFER SA_NOMASK SA_ONESHOT SA_ONSTACK SA_RESETHAND SA_RESTART SA_SIGINFO "
    "SA_STACK SCHAR_WIDTH SCM_CREDENTIALS SCM_RIGHTS SCM_TIMESTAMP SCM_TIMESTAMPING "
    "SCM_TIMESTAMPING_OPT_STATS SCM_TIMESTAMPING_PKTINFO SCM_TIMESTAMPNS SCM_TXTIME "
    "SCM_WIFI_STATUS SEEK_DATA SEEK_HOLE SEGV_ACCADI SEGV_ACCERR SEGV_ADIDERR SEGV_ADIPERR "
    "SEGV_BNDERR SEGV_MAPERR SEGV_MTEAERR SEGV_MTESERR SEGV_PKUERR SEM_FAILED SEM_VALUE_MAX "
    "SHRT_WIDTH SHUT_RD SHUT_RDWR SHUT_WR SIGEV_NONE SIGEV_SIGNAL SIGEV_THREAD SIGEV_THREAD_ID "
    "SIGSTKSZ SIG_ATOMIC_WIDTH SIG_BLOCK SIG_HOLD SIG_SETMASK SIG_UNBLOCK SIOCATMARK SIOCGPGRP "
    "SIOCGSTAMPNS_OLD SIOCGSTAMP_OLD SIOCSPGRP SIZE_WIDTH SI_ASYNCIO SI_ASYNCNL SI_DETHREAD "
    "SI_KERNEL SI_MESGQ SI_QUEUE SI_SIGIO SI_TIMER SI_TKILL SI_USER SNANF128 SNANF32 SNANF32X "
    "SNANF64X SNANL SOCK_CLOEXEC SOCK_DCCP SOCK_DGRAM SOCK_NONBLOCK SOCK_PACKET SOCK_RAW SOCK_RDM "
    "SOCK_SEQPACKET SOCK_STREAM SOMAXCONN SO_ACCEPTCONN SO_ATTACH_BPF SO_ATTACH_FILTER "
    "SO_ATTACH_REUSEPORT_CBPF SO_ATTACH_REUSEPORT_EBPF SO_BINDTODEVICE SO_BINDTOIFINDEX "
    "SO_BPF_EXTENSIONS SO_BROADCAST SO_BSDCOMPAT SO_BUF_LOCK SO_BUSY_POLL SO_BUSY_POLL_BUDGET "
    "SO_CNX_ADVICE SO_COOKIE SO_DEBUG SO_DETACH_BPF SO_DETACH_FILTER SO_DETACH_REUSEPORT_BPF "
    "SO_DOMAIN SO_DONTROUTE SO_ERROR SO_GET_FILTER SO_INCOMING_CPU SO_INCOMING_NAPI_ID "
    "SO_KEEPALIVE SO_LINGER SO_LOCK_FILTER SO_MARK SO_MAX_PACING_RATE SO_MEMINFO SO_NETNS_COOKIE "
    "SO_NOFCS SO_NO_CHECK SO_OOBINLINE SO_PASSCRED SO_PASSSEC SO_PEEK_OFF SO_PEERCRED "
    "SO_PEERGROUPS SO_PEERNAME SO_PEERSEC SO_PREFER_BUSY_POLL SO_PRIORITY SO_PROTOCOL SO_RCVBUF "
    "SO_RCVBUFFORCE SO_RCVLOWAT SO_RCVMARK SO_RCVTIMEO SO_RCVTIMEO_NEW SO_RCVTIMEO_OLD "
    "SO_RESERVE_MEM SO_REUSEADDR SO_REUSEPORT SO_RXQ_OVFL SO_SECURITY_AUTHENTICATION "
    "SO_SECURITY_ENCRYPTION_NETWORK SO_SECURITY_ENCRYPTION_TRANSPORT SO_SELECT_ERR_QUEUE SO_SNDBUF "
    "SO_SNDBUFFORCE SO_SNDLOWAT SO_SNDTIMEO SO_SNDTIMEO_NEW SO_SNDTIMEO_OLD SO_TIMESTAMP "
    "SO_TIMESTAMPING SO_TIMESTAMPING_NEW SO_TIMESTAMPING_OLD SO_TIMESTAMPNS SO_TIMESTAMPNS_NEW "
    "SO_TIMESTAMPNS_OLD SO_TIMESTAMP_NEW SO_TIMESTAMP_OLD SO_TXREHASH SO_TXTIME SO_TYPE "
    "SO_WIFI_STATUS SO_ZEROCOPY SPLICE_F_GIFT SPLICE_F_MORE SPLICE_F_MOVE SPLICE_F_NONBLOCK "
    "SS_DISABLE SS_ONSTACK STA_CLK STA_CLOCKERR STA_DEL STA_FLL STA_FREQHOLD STA_INS STA_MODE "
    "STA_NANO STA_PLL STA_PPSERROR STA_PPSFREQ STA_PPSJITTER STA_PPSSIGNAL STA_PPSTIME "
    "STA_PPSWANDER STA_RONLY STA_UNSYNC STDERR_FILENO STDIN_FILENO STDOUT_FILENO "
    "SYNC_FILE_RANGE_WAIT_AFTER SYNC_FILE_RANGE_WAIT_BEFORE SYNC_FILE_RANGE_WRITE "
    "SYNC_FILE_RANGE_WRITE_AND_WAIT S_BLKSIZE S_IEXEC S_IFBLK S_IFCHR S_IFDIR S_IFIFO S_IFLNK "
    "S_IFMT S_IFREG S_IFSOCK S_IREAD S_IRGRP S_IROTH S_IRUSR S_IRWXG S_IRWXO S_IRWXU S_ISBLK "
    "S_ISCHR S_ISDIR S_ISFIFO S_ISGID S_ISLNK S_ISREG S_ISSOCK S_ISUID S_ISVTX S_IWGRP S_IWOTH "
    "S_IWRITE S_IWUSR S_IXGRP S_IXOTH S_IXUSR S_TYPEISMQ S_TYPEISSEM S_TYPEISSHM "
    "TEMP_FAILURE_RETRY TIMER_ABSTIME TIMESPEC_TO_TIMEVAL TIMEVAL_TO_TIMESPEC TRAP_BRANCH "
    "TRAP_BRKPT TRAP_HWBKPT TRAP_TRACE TRAP_UNK TSS_DTOR_ITERATIONS TTY_NAME_MAX UCHAR_WIDTH "
    "UIO_MAXIOV ULLONG_WIDTH ULONG_LONG_MAX ULONG_WIDTH USHRT_WIDTH UTIME_NOW UTIME_OMIT "
    "WCHAR_WIDTH WCONTINUED WEXITED WEXITSTATUS WIFCONTINUED WIFEXITED WIFSIGNALED WIFSTOPPED "
    "WINT_WIDTH WNOHANG WNOWAIT WORD_BIT WSTOPPED WSTOPSIG WTERMSIG WUNTRACED XATTR_LIST_MAX "
    "XATTR_NAME_MAX XATTR_SIZE_MAX accept4 adjtime asprintf assert_perror basename be16toh be32toh "
    "be64toh blkcnt64_t blkcnt_t blksize_t c8rtomb caddr_t call_once canonicalize "
    "canonicalize_file_name canonicalizef canonicalizel carg cimag clock_adjtime clockid_t clone "
    "close_range comparison_fn_t conj cookie_close_function_t cookie_io_functions_t "
    "cookie_read_function_t cookie_seek_function_t cookie_write_function_t copy_file_range cproj "
    "cpu_set_t creal cuserid daddl daddr_t ddivl denorm_absent denorm_indeterminate denorm_present "
    "dev_t dfmal dmull drand48 drand48_data dsqrtl dsubl dup3 eaccess environ erand48 error_t "
    "euidaccess execveat execvpe exp10 exp10f exp10l f_owner_ex fadd faddl fallocate fcloseall "
    "fdiv fdivl fedisableexcept feenableexcept fegetexcept fegetmode femode_t fesetexcept "
    "fesetmode fetestexceptflag ffma ffmal file_handle fmaximum fmaximum_mag fmaximum_mag_num "
    "fmaximum_mag_numf fmaximum_mag_numl fmaximum_magf fmaximum_magl fmaximum_num fmaximum_numf "
    "fmaximum_numl fmaximumf fmaximuml fmaxmag fmaxmagf fmaxmagl fminimum fminimum_mag "
    "fminimum_mag_num fminimum_mag_numf fminimum_mag_numl fminimum_magf fminimum_magl fminimum_num "
    "fminimum_numf fminimum_numl fminimumf fminimuml fminmag fminmagf fminmagl fmul fmull "
    "fopencookie fpos64_t fpregset_t fromfp fromfpf fromfpl fromfpx fromfpxf fromfpxl fsblkcnt64_t "
    "fsblkcnt_t fsfilcnt64_t fsfilcnt_t fsid_t fsqrt fsqrtl fsub fsubl futimes futimesat "
    "get_current_dir_name getcpu getdate getdate_err getitimer getpayload getpayloadf getpayloadl "
    "getpriority getpt getresgid getresuid getrlimit getrusage gettid gettimeofday getumask gid_t "
    "grantpt greg_t gregset_t group_member htobe16 htobe32 htobe64 htole16 htole32 htole64 id_t "
    "ino64_t ino_t iscanonical isctype iseqsig issignaling issubnormal iszero itimerval jrand48 "
    "key_t lcong48 le16toh le32toh le64toh lgammaf128_r lgammaf32_r lgammaf32x_r lgammaf64_r "
    "lgammaf64x_r llogb llogbf llogbl locale_t loff_t lrand48 lutimes mallinfo mallinfo2 "
    "malloc_info malloc_stats malloc_trim malloc_usable_size mallopt mbrtoc8 mcontext_t memalign "
    "memfd_create memfrob memmem mempcpy memrchr mkostemp mkostemps mlock2 mmsghdr mode_t mrand48 "
    "mremap name_to_handle_at nextdown nextdownf nextdownl nextup nextupf nextupl nfds_t nlink_t "
    "nrand48 nullptr_t obstack_printf obstack_vprintf off64_t off_t once_flag open_by_handle_at "
    "pid_t pipe2 pkey_alloc pkey_free pkey_get pkey_mprotect pkey_set poll pollfd posix_openpt "
    "ppoll preadv preadv2 preadv64v2 prlimit process_madvise process_mrelease process_vm_readv "
    "process_vm_writev program_invocation_name program_invocation_short_name ptsname pvalloc "
    "pwritev pwritev2 pwritev64v2 quad_t rawmemchr readahead readv recvmmsg register_t "
    "remap_file_pages renameat2 rlim64_t rlim_t rlimit round_indeterminate round_to_nearest "
    "round_toward_infinity round_toward_neg_infinity round_toward_zero roundeven roundevenf "
    "roundevenl rusage sa_family_t sa_sigaction secure_getenv seed48 sendmmsg setitimer setns "
    "setpayload setpayloadf setpayloadl setpayloadsig setpayloadsigf setpayloadsigl setpriority "
    "setresgid setresuid setrlimit settimeofday si_addr si_addr_lsb si_arch si_band si_call_addr "
    "si_fd si_int si_lower si_overrun si_pkey si_ptr si_status si_stime si_syscall si_timerid "
    "si_upper si_utime sig_t sigabbrev_np sigandset sigdescr_np sigev_notify_attributes "
    "sigev_notify_function sigevent_t sighandler_t sighold sigignore siginfo_t sigisemptyset "
    "sigmask sigorset sigpause sigrelse sigset sigset_t sigsetjmp sigval_t sincos sincosf sincosl "
    "socklen_t splice srand48 ssize_t stack_t statx statx_timestamp strcasestr strchrnul strdupa "
    "strerrordesc_np strerrorname_np strfromd strfromf strfromf128 strfromf32 strfromf32x "
    "strfromf64x strfroml strfry strndupa strptime strtof128 strtof32 strtof32x strtof64_l "
    "strtof64x strverscmp suseconds_t swab sync_file_range syncfs sysv_signal tee tgkill timer_t "
    "timeradd timerclear timercmp timerisset timersub timespec_getres timex totalorder totalorderf "
    "totalorderl totalordermag totalordermagf totalordermagl u_int16_t u_int32_t u_int64_t "
    "u_int8_t u_quad_t ucontext_t ucred ufromfp ufromfpf ufromfpl ufromfpx ufromfpxf ufromfpxl "
    "uid_t unlockpt unshare useconds_t utimes vasprintf vmsplice wcschrnul wcstof128 wcstof32 "
    "wcstof32x wcstof64_l wcstof64x wcstoq wcstouq wcswcs wcswidth wcwidth wmempcpy writev ";
// clang-format on

using Names = std::set<std::string, std::less<>>;

Names list_names() {
  Names names;
  for (const char* list : {kKeywords, kMacros, kGlobals, kPosix}) {
    std::istringstream words(list);
    for (std::string word; words >> word;) names.insert(word);
  }
  return names;
}

/// `PRId64`, `SCNu8`, `INT_LEAST8_MAX`, `UINT64_C`, `LC_ALL`, `AF_INET`.
bool is_of_macro_family(std::string_view name) {
  if (name.starts_with("PRI") || name.starts_with("SCN")) {
    return name.size() > 4 && std::string_view("bBdiouxX").find(name[3]) != std::string_view::npos;
  }
  const bool integer = name.starts_with("INT") || name.starts_with("UINT");
  if (integer) {
    constexpr std::array<std::string_view, 4> kEndings = {"_MAX", "_MIN", "_C", "_WIDTH"};
    return std::ranges::any_of(kEndings, [name](auto end) { return name.ends_with(end); });
  }
  constexpr std::array<std::string_view, 13> kFamilies = {
      "AF_",     "PF_",     "SOL_",   "PTHREAD_", "STATX_", "CLONE_", "MADV_",
      "RLIMIT_", "FALLOC_", "SCHED_", "CLOCK_",   "POSIX_", "LC_"};
  const bool capital = std::ranges::none_of(name, [](char c) { return c >= 'a' && c <= 'z'; });
  return capital &&
         std::ranges::any_of(kFamilies, [name](auto begin) { return name.starts_with(begin); });
}

/// `pthread_create`, `cosf32x`, `f32addf64`, and variants as `qsort_r` of a name that is taken.
bool is_of_function_family(std::string_view name, const Names& names) {
  constexpr std::array<std::string_view, 7> kFamilies = {"pthread_", "sched_", "sem_", "mtx_",
                                                         "cnd_",     "thrd_",  "tss_"};
  if (std::ranges::any_of(kFamilies, [name](auto begin) { return name.starts_with(begin); })) {
    return true;
  }
  constexpr std::array<std::string_view, 11> kVariants = {
      "f16", "f32", "f32x", "f64", "f64x", "f128", "f128x", "_l", "_r", "_unlocked", "64"};
  const bool narrows = name.starts_with("f32") || name.starts_with("f64");
  return std::ranges::any_of(kVariants, [&](auto end) {
    if (!name.ends_with(end)) return false;
    std::string_view stem = name.substr(0, name.size() - end.size());
    if (names.contains(stem)) return true;
    if (!narrows) return false;
    stem.remove_prefix(3);
    if (stem.starts_with('x')) stem.remove_prefix(1);
    constexpr std::array<std::string_view, 6> kOperations = {"add", "div",  "fma",
                                                             "mul", "sqrt", "sub"};
    return std::ranges::find(kOperations, stem) != kOperations.end();
  });
}

}  // namespace

bool is_taken_name(std::string_view name) {
  static const auto names = list_names();
  return names.contains(name) || is_of_macro_family(name) || is_of_function_family(name, names);
}

}  // namespace treeline
